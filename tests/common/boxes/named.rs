//! Enumerations whose values have names for tables and for the command line.

/// Defines an enumeration from the variant, the name and the description of each value.
macro_rules! named {
    ($(#[$attribute:meta])* $type:ident { $($variant:ident $name:literal $description:literal)* }) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $type {
            $(#[doc = $description] $variant,)*
        }

        impl $type {
            /// All values, in the order of the tables.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            /// The name in tables and on the command line.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }
        }
    };
}
