"""The C headers of the commands that the library has, from the Khronos registry (khronos_api, which cargo has fetched)."""

import re
from xml.etree import ElementTree

NOTICE = """/* Made from the Khronos registry, {file}:
   Copyright (c) 2013-2018 The Khronos Group Inc., licensed under the Apache License, Version 2.0
   (http://www.apache.org/licenses/LICENSE-2.0). */
"""
GL_BEGINNING = """
#include <stddef.h>
#include <KHR/khrplatform.h>

#ifdef __cplusplus
extern "C" {
#endif

#define APIENTRY
#define APIENTRYP APIENTRY *
#define GLAPI extern
#define GLAPIENTRY APIENTRY
#define GLAPIENTRYP APIENTRYP
#define GL_APICALL GLAPI
#define GL_APIENTRY APIENTRY
#define GL_APIENTRYP APIENTRYP
"""
EGL_BEGINNING = """
#include <EGL/eglplatform.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wl_display;
struct wl_resource;
struct wl_buffer;
"""
END = """
#ifdef __cplusplus
}
#endif

#endif
"""
# Other names of the two headers, as each has everything.
ALIASES = {
    "GL/gl.h": ["GL/glext.h", "GL/glcorearb.h", "GLES2/gl2.h", "GLES2/gl2ext.h", "GLES3/gl3.h"],
    "EGL/egl.h": ["EGL/eglext.h"],
}


def write(folder, xml, functions):
    """Writes the headers; xml is the folder of the crate khronos_api, functions are the names that the library exports."""
    headers = {
        "GL/gl.h": header(xml / "api/xml/gl.xml", "__gl_h_", GL_BEGINNING, "GLAPI", "APIENTRY", "gl", functions),
        "EGL/egl.h": header(
            xml / "api_egl/api/egl.xml", "__egl_h_", EGL_BEGINNING, "EGLAPI", "EGLAPIENTRY", "egl", functions),
    }
    for name, text in headers.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
        for alias in ALIASES[name]:
            (folder / alias).parent.mkdir(parents=True, exist_ok=True)
            (folder / alias).write_text(f"#include <{name}>\n")


def header(path, guard, beginning, api, entry, prefix, functions):
    tree = ElementTree.parse(path).getroot()
    lines = [NOTICE.format(file=path.name), f"#ifndef {guard}", f"#define {guard} 1", beginning]
    for kind in tree.find("types"):
        # Types of OpenGL ES are the same; what needs no declaration is there already.
        if kind.get("api") is None and kind.get("name") not in ("khrplatform", "eglplatform", "stddef"):
            text = source(kind, entry)
            if text and ("typedef" in text or "struct" in text or "#" in text):
                lines.append(text if text.endswith((";", "}", "f")) else text + ";")
    lines.append("")
    lines += constants(tree)
    lines.append("")
    commands = {command.find("proto/name").text: command for command in tree.findall("commands/command")}
    lines += versions(tree, prefix, set(functions))
    for name in sorted(commands):
        # Types that only extensions of other systems have are not declared.
        if prefix == "gl" or name in functions:
            result, parameters = prototype(commands[name], entry)
            lines.append(f"typedef {result}({entry}P PFN{name.upper()}PROC)({parameters});")
            if name in functions:
                lines.append(f"{api} {result}{entry} {name}({parameters});")
    return "\n".join([*lines, END])


def source(node, entry):
    """The C of an element."""
    text = node.text or ""
    for child in node:
        text += f"{entry} " if child.tag == "apientry" else source(child, entry)
        text += child.tail or ""
    return text.strip() if node.tag in ("type", "param", "proto") else text


def constants(tree):
    seen = {}
    for group in tree.findall("enums"):
        for one in group.findall("enum"):
            if one.get("api") in (None, "gl", "egl"):
                suffix = {"u": "u", "ull": "ull"}.get(one.get("type"), "")
                seen.setdefault(one.get("name"), one.get("value") + suffix)
    return [f"#define {name} {value}" for name, value in seen.items()]


def versions(tree, prefix, functions):
    """A macro for each version and extension whose commands are all there."""
    apis = {"gl": ("gl", "gles2"), "egl": ("egl",)}[prefix]
    groups = [one for one in tree.findall("feature") if one.get("api") in apis]
    groups += [
        one for one in tree.findall("extensions/extension") if set(one.get("supported").split("|")) & {*apis, "glcore"}]
    macros = []
    for group in groups:
        wanted = {one.get("name") for one in group.findall("require/command")}
        # An extension without commands may be missing; a version is there with its commands.
        if wanted <= functions and (wanted or group.tag == "feature"):
            macros.append(f"#define {group.get('name')} 1")
    return sorted(set(macros))


def prototype(command, entry):
    name = command.find("proto/name").text
    result = re.sub(rf"\s*\b{name}$", "", source(command.find("proto"), entry)).strip() + " "
    return result, ", ".join(source(one, entry) for one in command.findall("param")) or "void"
