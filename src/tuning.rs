//! Constants that affect speed: those of the kernels, of threads and of queries, the prices of an update's operations, and others of an
//! update. Further constants of an update are in the files that read them.
//!
//! Neither events nor their order depend on them, except on [`ROOM_AHEAD`](update::ROOM_AHEAD); a few unit tests do. Each has its unit, the
//! effect of a larger and of a smaller value where that is not plain, and its module names the command that shows it. All were found on
//! x86-64 with 32 kB and 2 MB of cache per core. A factor of two in either direction costs a few per cent, so none is a setting.

/// Sorting and sweeping: the kernels. Shown by the package `unisize-peers`.
pub(crate) mod kernel {
    /// Boxes. Up to this many, one tube is faster than a grid. If larger: small worlds compare boxes that are far apart. If smaller: choosing
    /// a grid takes longer than the sweep.
    pub(crate) const ONE_TUBE_UP_TO: usize = 24;

    /// The size of a sample: one box in so many, at least and at most so many, or all if there are fewer.
    #[derive(Clone, Copy, PartialEq)]
    pub(crate) struct Sample {
        pub(crate) one_in: usize,
        pub(crate) range: [usize; 2],
    }

    /// The sample for choosing the grid. If larger: tens of microseconds per run. If smaller: a pattern in the order of the boxes misleads.
    pub(crate) const GRID_SAMPLE: Sample = Sample {
        one_in: 8,
        range: [16, 128],
    };

    /// The sample if the first one misleads. If larger: time. If smaller: an order of the boxes that misleads both leaves more boxes than a
    /// class should.
    pub(crate) const SECOND_SAMPLE: Sample = Sample {
        one_in: 4,
        range: [16, usize::MAX],
    };

    /// How a grid is chosen.
    #[derive(Clone, Copy)]
    pub(crate) struct Aim {
        pub(crate) sample: Sample,
        /// Shares of the boxes, for the cut axes and for the first. The grid is made for the size that this share does not exceed. If larger:
        /// a few large boxes make the strips too wide. If smaller: more boxes are on a border, or too large for the grid.
        pub(crate) sizes: [f64; 2],
        /// Whether strips may be as narrow as boxes. The places of boxes that are too large for them do not count.
        pub(crate) is_narrow: bool,
    }

    const fn aim(sample: Sample, cut_axes: f64, is_narrow: bool) -> Aim {
        let sizes = [cut_axes, 0.75];
        Aim {
            sample,
            sizes,
            is_narrow,
        }
    }

    /// The grids that are tried in turn until one nearly [fits](FITTING). If more: each try is a pass over the boxes. If fewer: plates in several
    /// directions share tubes.
    pub(crate) const GRID_TRIES: [Aim; 4] = [
        aim(GRID_SAMPLE, 0.75, false),
        aim(GRID_SAMPLE, 0.375, true),
        aim(GRID_SAMPLE, 0.125, true),
        aim(SECOND_SAMPLE, 0.75, false),
    ];

    /// Comparisons for each box. A grid with more, besides some for each pair, does not fit. If larger: boxes that crowd share a class with
    /// others. If smaller: good grids are rejected, and searching takes longer with more classes.
    pub(crate) const FITTING: f64 = 64.0;

    /// A factor. The grid of a class nearly fits up to so many times the comparisons. If none does, a later one must take so many times fewer
    /// than the first. If larger: boxes share tubes that would not with another grid. If smaller: more classes, which gain less than their
    /// look-ups cost.
    pub(crate) const FAR_FEWER: f64 = 4.0;

    /// Classes. The last one takes all boxes that are left, in one tube. If larger: look-ups between more pairs of classes. If smaller: boxes
    /// of very different sizes share a class.
    pub(crate) const MOST_CLASSES: usize = 8;

    /// A factor. A box that is so many times longer along the first axis than that size, and than strips are wide, is too large for a grid.
    /// If larger: one long floor makes each look-up in its tube visit all entries along it. If smaller: more classes.
    pub(crate) const LONG_FROM: f64 = 4.0;

    /// The sample for choosing which of two classes is looked up in the other. If larger: time. If smaller: chance decides.
    pub(crate) const EFFORT_SAMPLE: Sample = Sample {
        one_in: 256,
        range: [16, 64],
    };

    /// Comparisons for each box of two classes, in the cheaper direction, besides some for each pair; times the squared binary logarithm of
    /// their number. From so many on, a segment tree finds the pairs instead of look-ups. If larger: needles are compared with needles of
    /// another direction in tube after tube. If smaller: the tree takes longer than look-ups.
    pub(crate) const TREE_FROM: f64 = 3.0;

    /// Boxes. A node of the segment tree with at most so many intervals or points is a leaf, which compares the boxes that overlap on its axis.
    /// If larger: boxes are compared that a further axis would separate. If smaller: nodes of a few boxes, each of which costs more than it saves.
    pub(crate) const LEAF_UP_TO: usize = 64;

    /// The cost of a query before its first tube, in comparisons. If larger: large boxes are looked up among small ones. If smaller: small
    /// boxes among large ones.
    pub(crate) const QUERY: f64 = 128.0;

    /// The cost of visiting a tube, also if it is passed over, in comparisons: the search for the first entry to compare. If larger: small
    /// boxes are looked up among large ones. If smaller: large boxes among small ones.
    pub(crate) const VISIT: usize = 32;

    /// Shares of the boxes. The grid covers the space between these two quantiles. Nearer 0 and 1: a few boxes far out make the strips too
    /// wide. Nearer the middle: more boxes are outside of it.
    pub(crate) const GRID_PLACE_QUANTILES: [f64; 2] = [0.02, 0.98];

    /// A factor. So many times more strips than are between those quantiles have tubes of their own. If larger: more empty tubes. If smaller:
    /// boxes outside share tubes with boxes inside.
    pub(crate) const GRID_SPARE: f64 = 1.125;

    /// Box sizes, with one and with two cut axes: the width of a strip. If larger: more candidates per box. If smaller: more boxes on a
    /// border, which are entered twice. Best between 8 and 16, and between 4 and 8.
    pub(crate) const BOXES_PER_STRIP: [f64; 2] = [12.0, 6.0];

    /// Boxes. Strips are wider where tubes would have fewer than these on average, and so wide for boxes without a size. If larger: more
    /// comparisons in tubes that are crowded. If smaller: tubes of a few boxes, each of which costs more than it saves.
    pub(crate) const BOXES_A_TUBE: f64 = 32.0;

    /// Candidates per box. Strips are narrower where boxes are so dense that each would have more, because the sweep decides them in blocks
    /// of eight. If larger: two blocks per box. If smaller: more ghosts.
    pub(crate) const CANDIDATES_A_BOX: f64 = 8.0;

    /// How many times narrower strips become, at most, where boxes are dense. If larger: most boxes are on a border. If smaller: boxes have
    /// more candidates than a block decides.
    pub(crate) const NARROWED_UP_TO: f64 = 4.0;

    /// Comparisons for each entry of a tube, and for each pair among them. A sample says whether a tube takes more: then it is crowded,
    /// and its boxes are left to further classes. Where a sweep takes more nevertheless, a segment tree takes over. If larger: crowds are swept.
    /// If smaller: classes and trees where a sweep is as fast.
    pub(crate) const COMPARED_AN_ENTRY: u64 = 128;
    pub(crate) const COMPARED_A_PAIR: u64 = 16;

    /// Entries. A tube of at most so many is never crowded. If larger: crowds are swept. If smaller: further classes take longer than comparing
    /// each entry with each.
    pub(crate) const NO_CROWD_UP_TO: usize = 384;

    /// A factor. Nor is a tube of at most so many times the mean number of entries. If larger: crowds are swept. If smaller: each tube is
    /// sampled.
    pub(crate) const CROWD_FROM: usize = 4;

    /// Entries of a tube. Up to this many are sorted by insertion alone. If larger: insertion is quadratic. If smaller: dealing into buckets
    /// costs more than it saves.
    pub(crate) const INSERTION_UP_TO: usize = 12;

    /// Buckets per entry of a tube. If larger: walking along empty buckets. If smaller: more entries are left to insertion, each with a
    /// mispredicted branch.
    pub(crate) const BUCKETS_AN_ENTRY: usize = 2;

    /// Entries of a bucket. With more, the bucket is sorted before insertion. If larger: quadratic time where entries crowd. If smaller: a
    /// call where a few moves would do.
    pub(crate) const CROWDED_BUCKET: u32 = 24;

    /// Slabs, and boxes per slab. Work may be cut into so many slabs, and one more for each so many boxes, because a slab reserves about a
    /// hundred entries. If the first is smaller, or the second larger: threads idle that could share few boxes. Otherwise: memory, if a user
    /// asks for very many slabs.
    pub(crate) const SLABS_UP_TO: usize = 16;
    pub(crate) const BOXES_A_SLAB: usize = 64;

    /// Entries of all tables of tubes, per box. Each part of the boxes has a table of its own. If larger: memory. If smaller: where boxes are
    /// so far apart that there are about as many tubes as boxes, fewer threads deal them into tubes.
    pub(crate) const TABLED_TUBES_A_BOX: u64 = 8;

    /// Boxes. From this many on, `RankSweep` sorts its two axes in two threads. If larger: the second thread idles. If smaller: waking it
    /// takes longer than the sort.
    pub(crate) const SORT_BOTH_AXES_FROM: usize = 1 << 14;
}

/// Pairs over time: the tracker and the proxy table. Shown by `measure -- hard-motions`, and in whole worlds by the package `compare`.
pub(crate) mod update {
    /// Slots. A program may pass a box for a collider that is not known, and that may not exist. Up to this far beyond all known slots,
    /// queries find it at once. Colliders with the last so many indices are refused. If larger: a wrong handle takes more memory. If
    /// smaller: queries before the first update miss some boxes of a world whose colliders are passed in any order.
    pub(crate) const ROOM_AHEAD: usize = 1 << 16;

    /// Notes per slot. Boxes may be written any number of times between two updates; from this many notes on, repeated ones are removed. If
    /// larger: they take more memory. If smaller: they are sorted more often.
    pub(crate) const MOST_NOTES_A_SLOT: usize = 4;

    /// Boxes or pairs. Above this many, memory that only a full search needs is freed after it. If larger: half of all memory lies unused
    /// in nine updates of ten. If smaller: small worlds allocate in each full search.
    pub(crate) const KEEP_SCRATCH_UP_TO: usize = 1 << 12;
}

/// The prices of an update's operations, in tenths of a nanosecond, in whole worlds where the solver has emptied the caches. They are
/// chosen and not fitted, because the time of an update does not show what it saves or costs later. Their ratios decide what an update
/// does, their sums how many threads share it.
pub(crate) mod prices {
    /// Testing whether one of a candidate's proxies was touched. If larger: threads are woken for little. If smaller: cores idle.
    pub(crate) const PICKED: u64 = 10;

    /// Reading a collider, or the box that was passed for it: shapes and bodies are scattered in memory. If larger: threads are woken for
    /// little. If smaller: cores idle.
    pub(crate) const READ: u64 = 300;

    /// Comparing a candidate. If larger or smaller: the same.
    pub(crate) const COMPARED: u64 = 20;

    /// A factor for comparing and reading where not all volumes are balls. If larger or smaller: the same.
    pub(crate) const BEYOND_BALLS: u64 = 3;

    /// Testing whether a found candidate overlaps and was held. If larger or smaller: the same.
    pub(crate) const HELD: u64 = 60;

    /// Inflating, comparing or copying the box of a slot. If larger or smaller: the same.
    pub(crate) const SLOT: u64 = 30;

    /// Looking up a box in a sorted layer, without its visits; or a box of two lists between which a segment tree finds the pairs. If larger:
    /// full searches where a look-up would do. If smaller: tens of thousands of boxes are looked up one by one.
    pub(crate) const LOOKED_UP: u64 = 5000;

    /// A comparison of a look-up, or an equal cost: few for most boxes, many for moving walls. If larger or smaller: the same.
    pub(crate) const VISITED: u64 = 4;

    /// A box of a search: inflating, sorting and sweeping. If larger: few full searches. If smaller: many.
    pub(crate) const SEARCHED: u64 = 450;

    /// A candidate found: storing it, testing whether it was held, and comparing it in the next updates. If larger: tens of thousands of boxes
    /// are looked up one by one. If smaller: full searches where look-ups would do.
    pub(crate) const FOUND: u64 = 350;
}

/// When work is split across threads, in tenths of a nanosecond of estimated work on one thread.
pub(crate) mod threads {
    /// Debug builds split less work, so that tests need not be long.
    const SCALE: u64 = if cfg!(debug_assertions) { 16 } else { 1 };

    /// The least time that splitting must save an update, or a section of one, that begins outside of the pool. If larger: cores idle. If
    /// smaller: waking threads twice, and cold caches, cost more than they save: some 100 microseconds on a server, and more on a virtual
    /// machine.
    pub(crate) const ENTER_COST: u64 = 2_500_000 / SCALE;

    /// The least time that splitting must save a section of an update that runs in the pool. If larger: cores idle. If smaller: waking the
    /// other threads, 1 to 10 microseconds, costs more than it saves.
    pub(crate) const SECTION_COST: u64 = 200_000 / SCALE;

    /// The least part of a section. If larger: cores idle. If smaller: threads are woken for work that is done before they start.
    pub(crate) const PART_FROM: u64 = 100_000 / SCALE;
}

/// The tree for queries. Shown by `measure -- queries`, and by the package `compare` with `--rays 1`.
pub(crate) mod queries {
    /// Leaves. A tree of no more is built again when it loses one, because Parry's trees are not sound after losing nearly all leaves. Its
    /// leaves keep their places, because visiting all of them takes next to no time.
    pub(crate) const SMALL_UP_TO: u32 = 16;

    /// Updates. A tree that no query has used in this many is dropped. If larger: scenes without queries go on noting changes. If smaller: a
    /// program with rare queries builds a tree for each.
    pub(crate) const KEEP_UNASKED: u32 = 64;

    /// One leaf in this many. If fewer were renewed, each is written alone, with its ancestors; otherwise all nodes are computed again. If
    /// larger: a pass over the whole tree for a few leaves. If smaller: ancestors are written many times.
    pub(crate) const FEW_UP_TO_ONE_IN: usize = 8;

    /// One leaf in this many. Once more have been written alone or removed, the nodes are put in order, which tightens ancestors and frees
    /// the nodes of removed leaves. If smaller: rays visit more of the tree. If larger: time.
    pub(crate) const TIGHTEN_FROM_ONE_IN: usize = 2;

    /// A share. When many leaves were written at once, and more than this share has left the boxes for which they were inserted, the tree is
    /// built again. If smaller: time. If larger: rays visit more of the tree.
    pub(crate) const BUILD_FROM: f64 = 0.75;

    /// The sample of leaves for that. If larger: time. If smaller: chance decides.
    pub(crate) const STRAY_SAMPLE: usize = 64;
}
