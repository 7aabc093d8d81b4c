//! Structs of numbers, number by number: as other numbers, and in the lanes of wider ones.

/// Gives a struct of numbers `S<T>` what is needed to change the type of its numbers. The fields are listed
/// once: first its own numbers, then the structs of numbers that it holds.
macro_rules! fieldwise {
    ($name:ident { $($number:ident),*; $($part:ident),* }) => {
        impl<T> $name<T> {
            /// The value in another number type.
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
