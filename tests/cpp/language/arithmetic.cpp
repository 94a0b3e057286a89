// SPDX-License-Identifier: Apache-2.0


void run()
{
  int i = 7;
  int j = i / 2;
  num("a", j);
  num("b", i % 4);
  num("c", -i / 2);
  num("d", -7 % 3);
  double d = i / 2;
  num("e", d * 2);
  num("f", 7 / 2.0 * 2);
  i += 3;
  i *= 2;
  i -= 1;
  i /= 3;
  i %= 4;
  num("g", i);
  i <<= 3;
  num("h", i | 1);
  num("k", (i ^ 5) & 7);
  num("l", ~i);
  i >>= 1;
  num("m", i);
  int x = 3.9;
  num("n", x);
  x = 2.7;
  num("o", x);
  bool b = 5;
  num("p", b);
  b = 0.0;
  num("q", b);
  unsigned u = 3;
  num("r", u - 1);
  float f = 1;
  num("s", f / 2 * 4);
  long long big = 1'000'000;
  num("t", big / 1000);
  num("u", 0x1F + 0b11 + 017);
  num("v", 'a' == 97);
  char c = 'b';
  show(std::string("x_") + c);
  int y = 1, z = (y++, y + 1);
  num("z", z + y);
  num("aa", y++ + ++y);
  num("ab", y-- - --y);
  num("ac", +y - -y);
  num("ad", !y + !0);
  x = y = 4;
  num("ae", x + y);
  (x += 2) *= 3;
  num("af", x);
  num("ag", true + true);
}
