//! Properties, macros, blocks, conditions and arguments.

use super::{errors, expand, outcome};

#[test]
fn properties_are_evaluated_at_their_first_use() {
    assert_eq!(
        expand(
            "<xacro:property name=\"a\" value=\"${b + 1}\"/><xacro:property name=\"b\" value=\"1\"/><l a=\"${a} ${b}\"/>\
             <xacro:property name=\"b\" value=\"5\"/><l a=\"${a} ${b}\"/>"
        ),
        "<l a=\"2 1\"/><l a=\"2 5\"/>"
    );
    assert_eq!(
        expand(
            "<xacro:property name=\"a\" value=\"1\"/><xacro:property name=\"a\" value=\"${a + 1}\" lazy_eval=\"false\"/>\
             <l a=\"${a}\"/>"
        ),
        "<l a=\"2\"/>"
    );
    assert_eq!(
        expand(
            "<xacro:property name=\"a\" default=\"1\"/><xacro:property name=\"a\" default=\"2\"/><l a=\"${a}\"/>\
             <xacro:property name=\"a\" remove=\"true\"/><xacro:property name=\"a\" default=\"3\"/><l a=\"${a}\"/>"
        ),
        "<l a=\"1\"/><l a=\"3\"/>"
    );
}

#[test]
fn values_have_the_types_of_python() {
    assert_eq!(
        expand(
            "<xacro:property name=\"a\" value=\"1.50\"/><xacro:property name=\"b\" value=\" 2 \"/>\
             <xacro:property name=\"c\" value=\"true\"/><xacro:property name=\"d\" value=\"1_0\"/>\
             <xacro:property name=\"e1\" value=\"'007'\"/><xacro:property name=\"f\" value=\"007\"/>\
             <xacro:property name=\"g\" value=\"[1, 2]\"/><xacro:property name=\"h\" value=\"12345678901234567890\"/>\
             <l a=\"${a}\" b=\"${b}\" c=\"${c}\" d=\"${d}\" e=\"${e1}\" f=\"${f}\" g=\"${g}\" h=\"${h}\"/>"
        ),
        "<l a=\"1.5\" b=\"2\" c=\"True\" d=\"1_0\" e=\"7\" f=\"7\" g=\"[1, 2]\" h=\"12345678901234567890\"/>"
    );
    assert_eq!(
        expand("<l a=\"$${a} 5$ ${1}${'x'} &lt;&amp;\">${2 * 3} &lt; <![CDATA[${a}]]></l>"),
        "<l a=\"${a} 5$ 1x &lt;&amp;\">6 &lt; ${a}</l>"
    );
}

#[test]
fn macros_have_parameters_defaults_and_blocks() {
    assert_eq!(
        expand(
            "<xacro:property name=\"p\" value=\"7\"/><xacro:property name=\"q\" value=\"8\"/>\
             <xacro:macro name=\"m\" params=\"a b:=${p} c:='x y' q:=^ r:=^|9 *one **two\">\
             <l a=\"${a}\" b=\"${b}\" c=\"${c}\" q=\"${q}\" r=\"${r}\"><xacro:insert_block name=\"one\"/>\
             <xacro:insert_block name=\"two\"/></l></xacro:macro>\
             <xacro:m a=\"${p}\"><o x=\"${q}\"/><t><u/><v/></t></xacro:m>"
        ),
        "<l a=\"7\" b=\"7\" c=\"x y\" q=\"8\" r=\"9\"><o x=\"8\"/><u/><v/></l>"
    );
    assert_eq!(
        expand(
            "<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n &gt; 0}\"><l n=\"${n}\"/>\
             <xacro:m n=\"${n - 1}\"/></xacro:if></xacro:macro><xacro:call macro=\"${'m'}\" n=\"3\"/>"
        ),
        "<l n=\"3\"/><l n=\"2\"/><l n=\"1\"/>"
    );
    // A macro sees the properties of its caller.
    assert_eq!(
        expand(
            "<xacro:macro name=\"in\"><l a=\"${a}\"/></xacro:macro>\
             <xacro:macro name=\"out\" params=\"a\"><xacro:in/></xacro:macro><xacro:out a=\"1\"/>"
        ),
        "<l a=\"1\"/>"
    );
}

#[test]
fn properties_reach_other_scopes() {
    assert_eq!(
        expand(
            "<xacro:macro name=\"in\"><xacro:property name=\"a\" value=\"${2 * x}\" scope=\"parent\"/>\
             <xacro:property name=\"b\" value=\"${3 * x}\" scope=\"global\"/></xacro:macro>\
             <xacro:macro name=\"out\" params=\"x\"><xacro:in/><l a=\"${a}\"/></xacro:macro>\
             <xacro:out x=\"1\"/><l b=\"${b}\"/>"
        ),
        "<l a=\"2\"/><l b=\"3\"/>"
    );
    assert!(
        errors("<xacro:property name=\"a\" value=\"1\" scope=\"parent\"/>")
            .contains("there is no scope around the file")
    );
}

#[test]
fn blocks_are_properties_too() {
    assert_eq!(
        expand(
            "<xacro:property name=\"o\"><origin xyz=\"${x} 0 0\"/></xacro:property><xacro:property name=\"x\" value=\"1\"/>\
             <l><xacro:insert_block name=\"o\"/></l>"
        ),
        "<l><origin xyz=\"1 0 0\"/></l>"
    );
}

#[test]
fn conditions_choose() {
    assert_eq!(
        expand(
            "<xacro:if value=\"true\"><a/></xacro:if><xacro:unless value=\"1\"><b/></xacro:unless>\
             <xacro:if value=\"${'x' == 'y'}\"><xacro:undefined/></xacro:if><xacro:unless value=\"${[]}\"><c/></xacro:unless>"
        ),
        "<a/><c/>"
    );
    assert_eq!(
        errors("<xacro:if value=\"maybe\"/>"),
        "error: r.xacro:2:18: \"maybe\" is no condition\n  hint: write true, false or ${…} with a comparison\n"
    );
}

#[test]
fn elements_and_attributes_may_be_computed() {
    assert_eq!(
        expand(
            "<xacro:element xacro:name=\"${'li' + 'nk'}\" name=\"a\"><b/></xacro:element>\
             <l x=\"1\"><xacro:attribute name=\"y\" value=\"${2}\"/><xacro:attribute name=\"x\" value=\"3\"/></l>"
        ),
        "<link name=\"a\"><b/></link><l x=\"3\" y=\"2\"/>"
    );
    assert!(
        errors("<l><xacro:attribute name=\"a b\" value=\"1\"/></l>")
            .contains("\"a b\" is no name of an element or attribute")
    );
}

#[test]
fn arguments_have_defaults() {
    let text = "<xacro:arg name=\"type\" default=\"${'a' + 'b'}\"/><xacro:property name=\"n\" value=\"$(arg size)\"/>\
                <xacro:arg name=\"size\" default=\"0.5\"/>\
                <l a=\"$(arg type)\" n=\"${n + 1}\" e=\"$(eval size * 2)\" x=\"${xacro.arg('type')}\"/>";
    assert_eq!(expand(text), "<l a=\"ab\" n=\"1.5\" e=\"1.0\" x=\"ab\"/>");
    assert_eq!(
        outcome(text, &[("size", "2"), ("type", "c")]).unwrap(),
        "<l a=\"c\" n=\"3\" e=\"4\" x=\"c\"/>"
    );
    assert_eq!(
        errors("<l a=\"$(arg typ)\"/>"),
        "error: r.xacro:2:7: argument \"typ\" has no value\n  hint: declare it above by <xacro:arg name=\"typ\" \
         default=\"…\"/>, or give it: arguments(typ = \"…\") in attributes, .argument(\"typ\", \"…\") of the builder, \
         --arguments typ=… on the command line\n"
    );
}

#[test]
fn the_environment_is_not_read() {
    assert!(
        errors("<l a=\"$(env PATH)\"/>")
            .starts_with("error: r.xacro:2:7: environment variable \"PATH\" is not read")
    );
    assert_eq!(expand("<l a=\"$(optenv PATH a b)\"/>"), "<l a=\"a b\"/>");
    let given = outcome("<l a=\"$(env X)$(optenv X 0)\"/>", &[("X", "1")]);
    assert_eq!(given.unwrap(), "<l a=\"11\"/>");
    for path in ["cwd", "dirname"] {
        assert!(errors(&format!("<l a=\"$({path})\"/>")).contains("is a path of one machine"));
    }
    assert!(errors("<l a=\"$(argument x)\"/>").contains("known substitutions: arg, env"));
}

#[test]
fn every_mistake_is_reported_once() {
    assert_eq!(
        errors(
            "<xacro:property name=\"a\" value=\"${b}\"/>\n<l a=\"${a}\" b=\"${a}\"/>\n\
             <xacro:macro name=\"m\" params=\"x\">\n<l a=\"1 ${x / 0}\"/>\n</xacro:macro>\n\
             <xacro:m x=\"1\"/><xacro:m x=\"2\"/>\n<xacro:m y=\"1\"/>\n<xacro:n/>\n<xacro:property name=\"1\" value=\"2\"/>"
        ),
        "error: r.xacro:2:33: name \"b\" is not defined in \"${b}\"\n\
         error: r.xacro:5:9: division by zero in \"${x / 0}\" (in macro \"m\", called in line 7 of r.xacro)\n\
         error: r.xacro:8:10: macro \"m\" has no parameter \"y\"\n  hint: parameters: \"x\"\n\
         error: r.xacro:8:1: macro \"m\" needs \"x\"\n\
         error: r.xacro:9:1: there is no macro \"n\"\n  hint: macros: \"m\"\n\
         error: r.xacro:10:1: \"1\" is no name of a property\n  \
         hint: a name begins with a letter or _, has letters, digits and _, and is no word of Python\n"
    );
}

#[test]
fn macros_call_themselves_as_often_as_in_the_tool() {
    let text = "<xacro:macro name=\"m\" params=\"n\"><l/><xacro:if value=\"${n}\"><xacro:m n=\"${n - 1}\"/></xacro:if>\
                </xacro:macro><xacro:m n=\"300\"/>";
    assert_eq!(expand(text), "<l/>".repeat(301));
}
