// SPDX-License-Identifier: Apache-2.0
// Texts of a number of characters of a buffer, and of a string.
#include <cstdio>
#include <cstring>

static void run()
{
  { char b[64] = "cam_3x"; show("buffer0_" + std::string(b, 5)); }
  { char b[64]; int n = snprintf(b, sizeof b, "cam_%d", 4); show("buffer1_" + std::string(b, n)); }
  { char b[64]; strcpy(b, "cam_5x"); std::string s(b, 5); show("buffer2_" + s); }
  { char b[64]; int n = snprintf(b, sizeof b, "cam_%d", 4); std::string s(b, n); show("buffer3_" + s.substr(2)); }
  { std::string a = "cam_6"; show("buffer4_" + std::string(a, 2)); }
  { char b[8] = "abcdef"; std::string a = b; show("buffer5_" + std::string(a, 2) + std::string(b, 2)); }
  { char b[16]; snprintf(b, sizeof(b), "%s", "abc"); std::string a(b); a.assign(b, 2); a.append(b, 1); show("buffer6_" + a); }
  { char b[16] = {}; strncpy(b, "abcdef", 4); show("buffer7_" + std::string(b, 3)); }
  { struct P { char name[16]; }; P p; snprintf(p.name, sizeof(p.name), "n%d", 12); show("buffer8_" + std::string(p.name, 2)); }
}
