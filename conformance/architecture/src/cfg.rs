//! Whether an item is test code.

use syn::punctuated::Punctuated;
use syn::{Attribute, Meta, Token};

/// Whether no build without `test` has what carries these attributes: one of its `cfg` predicates is false for every
/// choice of the other options. `#[cfg(any(test, feature = "x"))]` is no test code, `#[cfg(all(test, unix))]` is.
/// Documentation tests (`doctest`) count as tests.
pub fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => {
            list.parse_args::<Meta>().is_ok_and(|predicate| value(&predicate) == Value::False)
        }
        Meta::List(_) | Meta::Path(_) | Meta::NameValue(_) => false,
    })
}

/// What is known of a predicate where `test` is not set.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Value {
    False,
    True,
    Unknown,
}

fn value(predicate: &Meta) -> Value {
    match predicate {
        Meta::Path(path) if path.is_ident("test") || path.is_ident("doctest") => Value::False,
        Meta::Path(_) | Meta::NameValue(_) => Value::Unknown,
        Meta::List(list) => {
            let Ok(inner) = list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)
            else {
                return Value::Unknown;
            };
            let values: Vec<Value> = inner.iter().map(value).collect();
            if list.path.is_ident("all") {
                decided(&values, Value::False, Value::True)
            } else if list.path.is_ident("any") {
                decided(&values, Value::True, Value::False)
            } else if list.path.is_ident("not") {
                match values.as_slice() {
                    [Value::False] => Value::True,
                    [Value::True] => Value::False,
                    _ => Value::Unknown,
                }
            } else {
                Value::Unknown
            }
        }
    }
}

/// `deciding` where one of the values is it, `other` where all are that.
fn decided(values: &[Value], deciding: Value, other: Value) -> Value {
    if values.contains(&deciding) {
        deciding
    } else if values.iter().all(|value| *value == other) {
        other
    } else {
        Value::Unknown
    }
}

#[cfg(test)]
mod tests {
    use super::is_test;

    fn holds(attribute: &str) -> bool {
        let item: syn::ItemStruct = syn::parse_str(&format!("{attribute} struct S;")).unwrap();
        is_test(&item.attrs)
    }

    #[test]
    fn only_what_needs_test_is_test_code() {
        for attribute in [
            "#[cfg(test)]",
            "#[cfg(doctest)]",
            "#[cfg(all(test, unix))]",
            "#[cfg(any(test, doctest))]",
            "#[cfg(all(unix, any(test, all(test, feature = \"x\"))))]",
            "#[cfg(unix)] #[cfg(test)]",
        ] {
            assert!(holds(attribute), "{attribute}");
        }
        for attribute in [
            "",
            "#[cfg(not(test))]",
            "#[cfg(any(test, feature = \"x\"))]",
            "#[cfg(any(unix, all(test, windows)))]",
            "#[cfg(all(unix, not(test)))]",
            "#[cfg(feature = \"test\")]",
        ] {
            assert!(!holds(attribute), "{attribute}");
        }
    }
}
