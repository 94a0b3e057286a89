// SPDX-License-Identifier: Apache-2.0
// Functions to which the classes lead that the template of an argument is made of.
namespace library
{
struct Json {std::string text;};
template<typename T> Json written(const T & value) {Json j; to_json(j, value); return j;}
template<typename T> T got(const Json & j) {T value; from_json(j, value); return value;}
}

namespace fleet
{
struct Robot {int id = 1;};
static void to_json(library::Json & j, const std::vector<Robot> & robots) {show("vector"); j.text = "v" + std::to_string(robots.size());}
static void to_json(library::Json & j, const std::map<std::string, std::vector<Robot>> & robots) {show("map"); j.text = "m" + std::to_string(robots.size());}
static void to_json(library::Json & j, const std::optional<Robot> &) {show("optional"); j.text = "o";}
static void from_json(const library::Json &, std::vector<Robot> & robots) {show("back"); robots.resize(3);}
}

static void run()
{
  show("led0_" + library::written(std::vector<fleet::Robot>(2)).text);
  show("led1_" + library::written(std::vector<fleet::Robot>{}).text);
  show("led2_" + library::written(std::map<std::string, std::vector<fleet::Robot>>{}).text);
  show("led3_" + library::written(std::optional<fleet::Robot>()).text);
  num("led4", library::got<std::vector<fleet::Robot>>(library::Json{}).size());
}
