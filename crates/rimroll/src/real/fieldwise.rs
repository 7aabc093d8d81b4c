//! Conversion of structs of numbers between number types, field by field.

/// Implements `map` and `write` for a struct `S<T>` over the number type `T`. The list of fields has the numbers
/// first and, after a semicolon, the fields that are such structs themselves.
macro_rules! fieldwise {
    ($name:ident { $($number:ident),*; $($part:ident),* }) => {
        impl<T> $name<T> {
            /// Converts each number to another number type.
            #[inline(always)]
            pub(crate) fn map<U>(&self, f: impl Fn(&T) -> U) -> $name<U> {
                $name {
                    $($number: f(&self.$number),)*
                    $($part: self.$part.map(&f),)*
                }
            }

            /// Writes each number into its counterpart.
            #[inline(always)]
            pub(crate) fn write<U>(&self, to: &mut $name<U>, f: impl Fn(&T, &mut U)) {
                $(f(&self.$number, &mut to.$number);)*
                $(self.$part.write(&mut to.$part, &f);)*
            }
        }
    };
}
pub(crate) use fieldwise;
