// SPDX-License-Identifier: Apache-2.0


void run()
{
  int s = 0;
  for (int i = 0, j = 10; i < j; ++i, --j) {
    if (i == 1) continue;
    if (i == 4) break;
    s += i * j;
  } num("a", s);
  int n = 0;
  while (n < 100) { if (++n > 5) break; if (n % 2) continue; s += n; } num("b", s);
  do { s--; if (s == 10) continue; if (s < 8) break; } while (s > 5);
  num("c", s);
  for (int k = 0; k < 6; k++) {
    switch (k) {
      case 0: s += 1;
      case 1: s += 2;
      break;
      default: s += 100;
      break;
      case 3: continue;
      case 4: { s += 3; break; }
    }
    s += 1000;
  } num("d", s);
  switch (2) { case 1: show("no"); case 2: show("yes"); default: show("too"); }
  switch (9) { default: show("def"); case 1: show("after"); }
  if (int v = s; v > 3) num("e", v);
  else num("f", v);
  if (s == 1) show("g");
  else if (s > 1) show("h");
  else show("i");
  for (auto x : {3, 1, 2}) num("j", x);
  for (int i = 0; i < 2; ++i) for (int j = 0; j < 2; ++j) { if (j == 1) continue; num("k", i * 10 + j); }
  int i = 0;
  for (; i < 3;) ++i;
  num("l", i);
  { int i = 9; num("m", i); } num("n", i);
  for (int i = 0; i < 3; ++i) { int i2 = i; { int i = i2 * 2; if (i == 2) continue; num("o", i); } }
  int w = 3;
  while (w --> 0) { if (w == 1) continue; num("p", w); } num("q", w);
  for (const char * t : {"u", "v"}) show(t);
  bool first = true;
  for (auto x : std::vector<int>{1, 2, 3}) { if (first) { first = false; continue; } num("r", x); }
}
