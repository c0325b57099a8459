# A header as Doxygen shall see it: the lines below #pragma once describe the file, and comments hold no markup, so that <use>, #rrggbb,
# @media and \n in them are what they are. Without the namespace, which all share, functions stand on the page of their header.
s|^namespace rinceau \{$||
s|^\}  // namespace rinceau$||
/^#pragma once/,/^$/ {
  s|^// |/// |
  /^#pragma once/ a\
/// \\file
}
/^\/\/\/ \\file/ b
/\/\/\// {
  h
  s|.*///<?||
  s|[\\<>@#&$%"]|\\&|g
  s|`([^`]*)`|<tt>\1</tt>|g
  x
  s|(.*///<?).*|\1|
  G
  s|\n||
}
