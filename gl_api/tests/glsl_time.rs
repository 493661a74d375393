//! Shaders that are short and expand to more than any machine computes: the compiler or the linker ends soon, with an
//! error that names the limit.

#[path = "common/cpu_time.rs"]
mod cpu_time;

use cpu_time::CpuTime;
use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use std::fmt::Write as _;
use std::time::Duration;

/// Half a second where it is compiled for speed.
const SOON: Duration =
    if cfg!(debug_assertions) { Duration::from_secs(5) } else { Duration::from_millis(500) };

/// What `work` returns, which takes little time of the processors.
fn soon<R>(name: &str, work: impl FnOnce() -> R) -> R {
    let start = CpuTime::begin();
    let result = work();
    let elapsed = start.elapsed();
    println!("{name}: {elapsed:?}");
    assert!(elapsed < SOON, "{name}: {elapsed:?}");
    result
}

/// The log of a shader that is not compiled or not linked.
fn refused(name: &str, source: &str) -> String {
    let compiled = soon(name, || compile(Stage::Fragment, source, &Options::default()));
    let Some(shader) = compiled.shader else { return compiled.log };
    let linked = soon(name, || link(&[&shader], &Bindings::default()));
    assert!(linked.program.is_none(), "{name} is linked");
    linked.log
}

/// Functions, each of which calls the one before as `call` says: `{}` is that one.
fn nested(first: &str, head: &str, call: &str, last: &str) -> String {
    let mut source = format!("{head} f0{first}\n");
    for level in 1..35 {
        let before = format!("f{}", level - 1);
        let _ = writeln!(source, "{head} f{level}{}", call.replace("{}", &before));
    }
    source + last
}

#[test]
fn calls_of_calls() {
    let sources = [
        ("empty", nested("(){}", "void", "(){{}();{}();}", "void main(){f34();}")),
        (
            "constants",
            nested(
                "(float a){return a;}",
                "float",
                "(float a){return {}(a)+{}(1.0);}",
                "void main(){gl_FragColor=vec4(f34(1.0));}",
            ),
        ),
        (
            "branches",
            nested(
                "(int a){}",
                "void",
                "(int a){if(a==0){}(0);else {}(1);if(a==1)return;{}(0);}",
                "void main(){f34(0);}",
            ),
        ),
        (
            "loops",
            nested(
                "(){}",
                "void",
                "(){for(int i=0;i<9;i++){{}();}while(false){}();}",
                "void main(){f34();}",
            ),
        ),
        (
            "arrays",
            nested(
                "(float a[60000]){a[0]=1.0;}",
                "void",
                "(float a[60000]){{}(a);{}(a);}",
                "float all[60000];void main(){f34(all);}",
            ),
        ),
        (
            "constant arrays",
            nested(
                "(const float a[60000]){}",
                "void",
                "(const float a[60000]){{}(a);{}(a);}",
                "float all[60000];void main(){f34(all);}",
            ),
        ),
        (
            "switches",
            "#version 130\n".to_owned()
                + &nested(
                    "(int a){}",
                    "void",
                    "(int a){switch(a){case 0:{}(1);break;default:{}(0);}}",
                    "void main(){f34(0);}",
                ),
        ),
        (
            "variables",
            nested("(){float a[60000];a[0]=1.0;}", "void", "(){{}();{}();}", "void main(){f34();}"),
        ),
    ];
    for (name, source) in sources {
        let log = refused(name, &source);
        assert!(log.contains("(more than 2097152 steps)"), "{name}: {log}");
        assert!(log.contains("at a call of `f34`, which line 3"), "{name}: {log}");
    }
}

#[test]
fn constants_and_macros() {
    let mut array = "#version 120\nconst float a[60000] = float[60000](0.0".to_owned();
    array.push_str(&",1.0".repeat(59_999));
    array.push_str(");\n");
    for number in 0..2000 {
        let _ = writeln!(array, "const float b{number} = a[{number}] + a[7];");
    }
    array.push_str("void main(){gl_FragColor=vec4(b1);}");
    let wide = {
        let names: Vec<String> = (0..5000).map(|i| format!("p{i}")).collect();
        let call = vec!["1"; 5000].join(",");
        let sum = names[4999].clone() + &format!(" {}", names[4999]).repeat(3000);
        let mut source = format!("#define F({}) {sum}\n", names.join(","));
        (0..20).for_each(|_| {
            let _ = writeln!(source, "F({call})");
        });
        source
    };
    let chain = {
        let mut source = "#define F(a) a\n#define M0 ".to_owned() + &"F(1) ".repeat(5000) + "\n";
        for level in 1..5000 {
            let _ = writeln!(source, "#define M{level} M{}", level - 1);
        }
        source + "M4999\nM4999\n"
    };
    let overloads = {
        let ty = |digit: u32| ["float", "vec2", "vec3", "vec4"][digit as usize % 4];
        let types =
            |number: u32| (0..6).map(|at| ty(number >> (2 * at))).collect::<Vec<_>>().join(", ");
        let mut source: String =
            (0..1 << 12).map(|number| format!("void f({});\n", types(number))).collect();
        source.push_str("void main() {\n");
        (0..4096).for_each(|_| source.push_str("f(1.0, 1.0, 1.0, 1.0, 1.0, 1.0);\n"));
        source + "}"
    };
    let all = [
        ("constant arrays", array),
        ("parameters", wide),
        ("chain", chain),
        ("overloads", overloads),
    ];
    for (name, source) in all {
        let log = refused(name, &source);
        assert!(log.contains("(more than 2097152 steps)"), "{name}: {log}");
        assert!(log.starts_with("0:"), "{name}: no line in {log}");
    }
    let mut bomb = "#define M0 1.0 + 1.0\n".to_owned();
    for level in 1..40 {
        let _ = writeln!(bomb, "#define M{level} M{0} + M{0}", level - 1);
    }
    let log = refused("macro bomb", &(bomb + "float f = M39;\n"));
    assert!(log.contains("more than 1048576 tokens"), "{log}");
}

/// What is long, and grows with its source only, is compiled: a variable and a constant for each of many loops, calls of
/// functions with many overloads.
#[test]
fn many_loops_and_lookups() {
    let shader = |line: &str, count: usize| {
        let lines = line.repeat(count);
        format!(
            "#version 130\nuniform sampler2D t; uniform float u; void main() {{ vec4 s = vec4(0.0);\n{lines}gl_FragColor = s; }}"
        )
    };
    for (name, source) in [
        ("loops", shader("for (int j = 2 - 2; j < 9; j++) s = s * s + u;\n", 3000)),
        ("lookups", shader("s += texture(t, s.xy);\n", 5000)),
    ] {
        let start = CpuTime::begin();
        let compiled = compile(Stage::Fragment, &source, &Options::default());
        let shader = compiled.shader.unwrap_or_else(|| panic!("{name}: {}", compiled.log));
        let linked = link(&[&shader], &Bindings::default());
        assert!(linked.program.is_some(), "{name}: {}", linked.log);
        let elapsed = start.elapsed();
        println!("{name}: {elapsed:?}");
        assert!(elapsed < SOON, "{name}: {elapsed:?}");
    }
}
