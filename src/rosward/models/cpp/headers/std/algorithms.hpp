// SPDX-License-Identifier: Apache-2.0
// std: algorithms that ask several ranges in turn, that swap what iterators lead to, and those of numbers.

namespace std
{
template<class A, class B>
void iter_swap(A a, B b)
{
  std::swap(*a, *b);
}
template<class A, class B, class Out, class Less>
Out set_intersection(A a, A last_a, B b, B last_b, Out out, Less less)
{
  while (a != last_a && b != last_b) {
    if (less(*a, *b)) {
      ++a;
    } else {
      if (!less(*b, *a)) {
        *out++ = *a++;
      }
      ++b;
    }
  }
  return out;
}
template<class A, class B, class Out>
Out set_intersection(A a, A last_a, B b, B last_b, Out out)
{
  return set_intersection(a, last_a, b, last_b, out, [](const auto & x, const auto & y) {return x < y;});
}
template<class A, class B, class Out, class Less>
Out set_difference(A a, A last_a, B b, B last_b, Out out, Less less)
{
  while (a != last_a) {
    if (b == last_b || less(*a, *b)) {
      *out++ = *a++;
    } else {
      if (!less(*b, *a)) {
        ++a;
      }
      ++b;
    }
  }
  return out;
}
template<class A, class B, class Out>
Out set_difference(A a, A last_a, B b, B last_b, Out out)
{
  return set_difference(a, last_a, b, last_b, out, [](const auto & x, const auto & y) {return x < y;});
}
template<class A, class B, class Out, class Less>
Out set_symmetric_difference(A a, A last_a, B b, B last_b, Out out, Less less)
{
  while (a != last_a || b != last_b) {
    if (b == last_b || (a != last_a && less(*a, *b))) {
      *out++ = *a++;
    } else if (a == last_a || less(*b, *a)) {
      *out++ = *b++;
    } else {
      ++a;
      ++b;
    }
  }
  return out;
}
template<class A, class B, class Out>
Out set_symmetric_difference(A a, A last_a, B b, B last_b, Out out)
{
  return set_symmetric_difference(a, last_a, b, last_b, out, [](const auto & x, const auto & y) {return x < y;});
}
template<class A, class B, class Out, class Less>
Out set_union(A a, A last_a, B b, B last_b, Out out, Less less)
{
  while (a != last_a || b != last_b) {
    if (b == last_b || (a != last_a && less(*a, *b))) {
      *out++ = *a++;
    } else if (a == last_a || less(*b, *a)) {
      *out++ = *b++;
    } else {
      *out++ = *a++;
      ++b;
    }
  }
  return out;
}
template<class A, class B, class Out>
Out set_union(A a, A last_a, B b, B last_b, Out out)
{
  return set_union(a, last_a, b, last_b, out, [](const auto & x, const auto & y) {return x < y;});
}
template<class A, class B, class Out, class Less>
Out merge(A a, A last_a, B b, B last_b, Out out, Less less)
{
  while (a != last_a || b != last_b) {
    if (b == last_b || (a != last_a && !less(*b, *a))) {
      *out++ = *a++;
    } else {
      *out++ = *b++;
    }
  }
  return out;
}
template<class A, class B, class Out>
Out merge(A a, A last_a, B b, B last_b, Out out)
{
  return merge(a, last_a, b, last_b, out, [](const auto & x, const auto & y) {return x < y;});
}
template<class A, class B, class T, class Add, class Times>
T inner_product(A a, A last_a, B b, T start, Add add, Times times)
{
  for (; a != last_a; ++a, ++b) {
    start = add(start, times(*a, *b));
  }
  return start;
}
template<class A, class B, class T>
T inner_product(A a, A last_a, B b, T start)
{
  const auto add = [](const auto & x, const auto & y) {return x + y;};
  return inner_product(a, last_a, b, start, add, [](const auto & x, const auto & y) {return x * y;});
}
template<class A, class Out, class Of>
Out partial_sum(A a, A last_a, Out out, Of of)
{
  if (a == last_a) {
    return out;
  }
  auto sum = *a;
  *out++ = sum;
  for (++a; a != last_a; ++a) {
    sum = of(sum, *a);
    *out++ = sum;
  }
  return out;
}
template<class A, class Out>
Out partial_sum(A a, A last_a, Out out)
{
  return partial_sum(a, last_a, out, [](const auto & x, const auto & y) {return x + y;});
}
template<class A, class Out, class Of>
Out adjacent_difference(A a, A last_a, Out out, Of of)
{
  if (a == last_a) {
    return out;
  }
  auto before = *a;
  *out++ = before;
  for (++a; a != last_a; ++a) {
    auto here = *a;
    *out++ = of(here, before);
    before = here;
  }
  return out;
}
template<class A, class Out>
Out adjacent_difference(A a, A last_a, Out out)
{
  return adjacent_difference(a, last_a, out, [](const auto & x, const auto & y) {return x - y;});
}
template<class M, class N>
int gcd(M m, N n)
{
  while (n != 0) {
    auto rest = m % n;
    m = n;
    n = rest;
  }
  return m < 0 ? -m : m;
}
template<class M, class N>
int lcm(M m, N n) {return m == 0 || n == 0 ? 0 : m / gcd(m, n) * n;}
}  // namespace std
