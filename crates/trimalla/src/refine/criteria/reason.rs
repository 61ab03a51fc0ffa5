//! Why triangles stay bad, and why a refinement ends.

use std::fmt;

/// Why a triangle stayed bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Reason {
    /// The smallest angle of the triangle lies between two input segments that meet; or the triangle lies between two
    /// segments that meet and are within rounding of each other there. Segments meet at common ends, at a vertex of one
    /// inside the other, and at crossings.
    InputAngle,
    /// The shortest edge of the triangle joins two segments that meet at an angle below the bound, as far from their
    /// common end on one as on the other. If the edge joins vertices of the input, those are within rounding of each
    /// other.
    AcrossSmallInputAngle,
    /// Two vertices of the input, a vertex and a segment, or two segments are within rounding of each other. The
    /// triangle lies across that gap, where no vertex fits; or the split or vertex that it needs has no room beside the
    /// gap.
    InputGap,
    /// A segment that may not be split is in the way.
    ProtectedSegment,
    /// Rounding leaves no room for another vertex.
    PrecisionFloor,
    /// A new vertex would be closer to another one than the length floor allows.
    SizeFloor,
    /// The vertex budget was used up.
    Budget,
    /// The caller cancelled.
    Cancelled,
    /// The strategy has no point that would improve the triangle.
    StrategyCannotImprove,
    /// The order is `manual`, and the triangle was not picked.
    NotPicked,
}

impl Reason {
    /// Every reason.
    pub const ALL: [Self; 10] = [
        Self::InputAngle,
        Self::AcrossSmallInputAngle,
        Self::InputGap,
        Self::ProtectedSegment,
        Self::PrecisionFloor,
        Self::SizeFloor,
        Self::Budget,
        Self::Cancelled,
        Self::StrategyCannotImprove,
        Self::NotPicked,
    ];

    /// The reason in words, as reports and JSON spell it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::InputAngle => "input angle",
            Self::AcrossSmallInputAngle => "across a small input angle",
            Self::InputGap => "input gap",
            Self::ProtectedSegment => "protected segment",
            Self::PrecisionFloor => "precision floor",
            Self::SizeFloor => "size floor",
            Self::Budget => "budget",
            Self::Cancelled => "cancelled",
            Self::StrategyCannotImprove => "strategy cannot improve",
            Self::NotPicked => "not picked",
        }
    }

    /// Whether the input itself forces the triangle to stay bad: no refinement could do better.
    #[must_use]
    pub const fn is_forced(self) -> bool {
        matches!(self, Self::InputAngle | Self::AcrossSmallInputAngle | Self::InputGap)
    }
}

serialized_by_key!(Reason, StopReason);

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// Why a refinement ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum StopReason {
    /// No triangle was left that could be treated.
    #[default]
    Finished,
    /// The vertex budget was used up.
    Budget,
    /// The caller cancelled.
    Cancelled,
    /// At an angle bound above 33 degrees, with at least twenty times the vertices of the forecast, the last doubling
    /// of the vertices left no fewer bad triangles: more vertices would only make more of them. Or none of several
    /// [attempts](crate::refine::Attempts) met the bound, and the mesh is that of a lower one.
    NoLongerImproves,
}

impl StopReason {
    /// Every reason.
    pub const ALL: [Self; 4] = [Self::Finished, Self::Budget, Self::Cancelled, Self::NoLongerImproves];

    /// The reason in words, as JSON spells it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Budget => "budget",
            Self::Cancelled => "cancelled",
            Self::NoLongerImproves => "no longer improves",
        }
    }
}
