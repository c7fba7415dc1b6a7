# Writes OUTPUT, a C++ source that holds the style sheet and the scripts of the folder PAGE as two texts. What a script
# runs at once, it finds in those before it; nothing of them is seen outside of one function.
file(READ ${PAGE}/page.css css)
set(script "\"use strict\";\n(() => {\n")
foreach(part decode tone_map difference painting words controls viewer legends start)
  file(READ ${PAGE}/${part}.js content)
  string(APPEND script "${content}\n")
endforeach()
string(APPEND script "})();\n")
file(WRITE ${OUTPUT} "#include \"tools/study/page_assets.h\"

namespace tress {
const char* const kPageCss = R\"tress_page(${css})tress_page\";
const char* const kPageScript = R\"tress_page(${script})tress_page\";
}  // namespace tress
")
