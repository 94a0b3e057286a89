# SPDX-License-Identifier: Apache-2.0
"""Random programs of strings and containers, which say what they hold: once for a compiler, once as a node with a topic for each thing said.

Texts are of a few letters and digits, so that they can stand in the name of a topic.
"""

from __future__ import annotations

import random
from typing import Final

HEAD: Final = """#include <algorithm>
#include <iomanip>
#include <iostream>
#include <list>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>
"""
COMPILED: Final = (
    HEAD
    + """
void say(const std::string & text) { std::cout << text << "\\n"; }
"""
)
FOLLOWED: Final = (
    HEAD
    + """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
static std::shared_ptr<rclcpp::Node> node;
void say(const std::string & text) { node->create_publisher<std_msgs::msg::String>(text, 1); }
"""
)
HELPERS: Final = """
std::string num(long n) { return n < 0 ? "m" + std::to_string(-n) : std::to_string(n); }
std::string at(std::size_t n) { return n == std::string::npos ? "nowhere" : std::to_string(n); }
std::string all(const std::vector<std::string> & v) { std::string r; for (const auto & s : v) { r += s + "z"; } return r; }
std::string nums(const std::vector<int> & v) { std::string r; for (int n : v) { r += num(n) + "z"; } return r; }
void work()
{
  std::string s = "abcab", t = "b1";
  std::vector<std::string> v{"c", "a", "b"};
  std::vector<int> w = {3, 1, 2};
  std::map<std::string, int> m{{"b", 2}, {"a", 1}};
  std::set<std::string> u{"b", "a"};
  std::list<int> l(2, 7);
  int n = 4;
"""
OPERATIONS: Final = (
    's += "{t}";',
    's = "{t}" + s;',
    "s += t[0];",
    "s.insert({i} % (s.size() + 1), \"{t}\");",
    "s.erase({i} % (s.size() + 1), {i});",
    "s.replace({i} % (s.size() + 1), {i}, \"{t}\");",
    "if (!s.empty()) {{ s.pop_back(); }}",
    "s = s.substr({i} % (s.size() + 1), {j});",
    "s.append({i}, '{c}');",
    "s.resize({i}, '{c}');",
    "std::replace(s.begin(), s.end(), '{c}', '{d}');",
    "std::reverse(s.begin(), s.end());",
    "std::sort(s.begin(), s.end());",
    "s.erase(std::remove(s.begin(), s.end(), '{c}'), s.end());",
    "std::transform(s.begin(), s.end(), s.begin(), ::toupper);",
    "std::transform(s.begin(), s.end(), s.begin(), [](char c) {{ return static_cast<char>(std::tolower(c)); }});",
    "std::swap(s, t);",
    "if (!s.empty()) {{ s[{i} % s.size()] = '{c}'; }}",
    "if (s.size() > 1) {{ s.erase(s.begin() + 1); }}",
    "t = std::string(s.rbegin(), s.rend());",
    "t = s + num(n);",
    "t = s.size() > {i} ? s : t;",
    "n = static_cast<int>(s.find(\"{t}\"));",
    "n = n * {i} - {j};",
    "n = n / {i1};",
    "n %= {i1};",
    "n = (n << {i}) & 255;",
    "n = std::max(n, {i}) + std::min({j}, n);",
    "for (char c : s) {{ n += c == '{c}'; }}",
    "n += s[0] - 'a';",
    "v.push_back(\"{t}\");",
    "v.emplace_back(s, 0, {i} % (s.size() + 1));",
    "v.insert(v.begin() + {i} % (v.size() + 1), t);",
    "if (!v.empty()) {{ v.erase(v.begin() + {i} % v.size()); }}",
    "if (v.size() > 4) {{ v.resize(3); }}",
    "v.resize(v.size() + 1, \"{c}\");",
    "std::sort(v.begin(), v.end());",
    "std::sort(v.begin(), v.end(), [](const std::string & a, const std::string & b) "
    "{{ return a.size() < b.size() || (a.size() == b.size() && a > b); }});",
    "v.erase(std::unique(v.begin(), v.end()), v.end());",
    "v.erase(std::remove_if(v.begin(), v.end(), [&](const auto & x) {{ return x.size() > {i}; }}), v.end());",
    "for (auto & x : v) {{ x += '{c}'; }}",
    "for (auto it = v.begin(); it != v.end(); ++it) {{ *it = '{c}' + *it; }}",
    "std::rotate(v.begin(), v.begin() + {i} % (v.size() + 1), v.end());",
    "v.insert(v.end(), u.begin(), u.end());",
    "t = std::accumulate(v.begin(), v.end(), std::string(\"{c}\"));",
    "v = std::vector<std::string>({j} % 3, \"{t}\");",
    "if (!v.empty()) {{ v.front().swap(v.back()); }}",
    "w.push_back(n % 50);",
    "std::sort(w.begin(), w.end(), std::greater<int>());",
    "std::transform(w.begin(), w.end(), w.begin(), [n](int x) {{ return x * 2 - n % 3; }});",
    "n = std::accumulate(w.begin(), w.end(), 0) % 1000;",
    "w.assign({j}, {i});",
    "if (!w.empty()) {{ *std::max_element(w.begin(), w.end()) = 0; }}",
    "std::iota(w.begin(), w.end(), {i});",
    "std::copy_if(w.begin(), w.end(), std::back_inserter(w = std::vector<int>(w)), [](int) {{ return false; }});",
    "m[\"{t}\"] += {i};",
    "m[s] = n % 100;",
    "m.erase(\"{t}\");",
    "m.emplace(\"{t}\", {j});",
    "m.insert({{\"{c}\", {i}}});",
    "m.insert_or_assign(\"{c}\", {i});",
    "for (auto & [key, value] : m) {{ value += static_cast<int>(key.size()); }}",
    "for (auto it = m.begin(); it != m.end();) {{ if (it->second % 2) {{ it = m.erase(it); }} else {{ ++it; }} }}",
    "if (auto it = m.find(\"{c}\"); it != m.end()) {{ it->second *= 2; t += it->first; }}",
    "n += static_cast<int>(m.count(\"{t}\")) + m.size();",
    "try {{ n = m.at(\"{t}\"); }} catch (const std::out_of_range &) {{ n = 5; }}",
    "u.insert(\"{t}\");",
    "u.insert(v.begin(), v.end());",
    "u.erase(\"{t}\");",
    "if (u.size() > 5) {{ u.erase(u.begin()); }}",
    "l.push_front(n % 10);",
    "l.remove(7);",
    "l.sort();",
    "if (l.size() > 4) {{ l.pop_back(); }}",
    "{{ std::ostringstream os; os << s << n % 7 << std::setw({j}) << std::setfill('x') << {i} << std::hex << 30 + {i}; t = os.str(); }}",
    "{{ std::istringstream is(\"{t} {i} {c}\"); std::string x; is >> x >> n; t = x; }}",
    "{{ std::stringstream parts(s); std::string part; v.clear(); while (std::getline(parts, part, '{c}')) {{ v.push_back(part); }} }}",
    "{{ std::optional<int> o; if (n % 2) {{ o = n % 9; }} n = o.value_or({i}); }}",
    "{{ char text[64]; std::snprintf(text, sizeof(text), \"%02d%s%x\", {i}, \"{t}\", {j} + 9); t = text; }}",
    "s = s.substr(0, 12); t = t.substr(0, 9); n %= 500;",
    "if (v.size() > 6) {{ v.erase(v.begin(), v.begin() + 3); }}",
    "if (w.size() > 6) {{ w.erase(w.begin() + 2, w.end()); }}",
)  # fmt: skip
QUESTIONS: Final = (
    "s", "t", "num(n)", "all(v)", "nums(w)", "all(std::vector<std::string>(u.begin(), u.end()))",
    "nums(std::vector<int>(l.begin(), l.end()))", 'at(s.find("{t}"))', 'at(s.rfind("{c}"))', 'at(s.find_first_of("{t}"))',
    'at(s.find_last_not_of("{t}"))', 'at(s.find_first_not_of("{c}", {i}))', "num(s.compare(t) < 0)", "num(s == t)",
    'num(std::count(s.begin(), s.end(), \'{c}\'))', 'num(std::find(v.begin(), v.end(), "{t}") - v.begin())',
    "num(std::any_of(w.begin(), w.end(), [](int x) {{ return x > {i}; }}))", "num(w.size() * 2 + v.size() + m.size())",
    "(m.empty() ? t : m.begin()->first + num(m.rbegin()->second))", 'num(m.lower_bound("{t}") == m.end())',
    "num(std::distance(u.begin(), u.lower_bound(\"{t}\")))", "(v.empty() ? s : v.front() + v.back())",
    "num(v < std::vector<std::string>{{\"{t}\"}})", "num(std::stoi(\"{i}{j}\") + n % 3)", "num(s < t)",
)  # fmt: skip
_LETTERS: Final = "abc1"


def program(seed: int, length: int = 25) -> str:
    """The body of a program."""
    source = random.Random(seed)
    lines = [HELPERS]
    for number in range(length):
        lines.append("  " + _filled(source, source.choice(OPERATIONS)))
        lines.append("  if (s.size() > 12) { s.resize(12); } if (t.size() > 12) { t.resize(12); }")
        question = _filled(source, source.choice(QUESTIONS))
        lines.append(f'  say("r{number}x" + std::string({question}));')
    return "\n".join([*lines, "}"])


def _filled(source: random.Random, template: str) -> str:
    text = "".join(source.choice(_LETTERS) for _ in range(source.randint(1, 2)))
    return template.format(
        t=text,
        c=source.choice(_LETTERS),
        d=source.choice(_LETTERS),
        i=source.randint(0, 4),
        j=source.randint(0, 4),
        i1=source.randint(1, 5),
    )


def compiled(body: str) -> str:
    """The program for a compiler."""
    return f"{COMPILED}{body}\nint main() {{ work(); }}\n"


def followed(body: str) -> str:
    """The program as a node."""
    return (
        f"{FOLLOWED}{body}\nint main(int argc, char ** argv)\n{{\n  rclcpp::init(argc, argv);\n"
        '  node = std::make_shared<rclcpp::Node>("sayer");\n  work();\n  rclcpp::spin(node);\n}\n'
    )
