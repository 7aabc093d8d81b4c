//! Operations on all lanes as functions of their own, so that kernels which use them consist of calls. Such kernels
//! compile in a fraction of the time that inlined operations take, and run slower.

/// Defines functions that act on each element of arrays.
macro_rules! elementwise {
    ($($name:ident($($argument:ident: $element:ident),*);)*) => {
        $(#[inline(never)]
        pub(super) fn $name<$($element: Copy,)* Y: Copy, const COUNT: usize>(
            $($argument: &[$element; COUNT],)*
            f: impl Fn($($element),*) -> Y,
        ) -> [Y; COUNT] {
            let mut result = [f($($argument[0]),*); COUNT];
            for i in 1..COUNT {
                result[i] = f($($argument[i]),*);
            }
            result
        })*
    };
}
elementwise! {
    map(a: A);
    map_2(a: A, b: B);
    map_3(a: A, b: B, c: C);
}
