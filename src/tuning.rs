//! The numbers of policy: what decides speed and nothing else. Those of the kernels that are there to be studied and compared
//! with, and sizes of buffers and batches, stand where they are used.
//!
//! No event depends on them, nor does the order of events; a few unit tests do. Each has its unit, what
//! goes wrong above and below, and the command that shows it. All were found on x86-64 with 32 kB and 2 MB of cache per core; a
//! factor of two to either side costs a few per cent, which is why none is a setting.

/// Sorting and sweeping: the kernels. Shown by `cargo run --release --package unisize-peers`.
pub(crate) mod kernel {
    /// Boxes. Up to this many, one tube is faster than a grid. Above: small worlds compare what is far apart. Below:
    /// choosing a grid takes longer than the sweep.
    pub(crate) const ONE_TUBE_UP_TO: usize = 24;

    /// How many of many boxes are looked at: one in so many, at least and at most so many, or all if they are few.
    #[derive(Clone, Copy)]
    pub(crate) struct Sample {
        pub(crate) one_in: usize,
        pub(crate) range: [usize; 2],
    }

    /// To choose the grid. More: tens of microseconds a run. Fewer: a pattern in the order of the boxes misleads.
    pub(crate) const GRID_SAMPLE: Sample = Sample {
        one_in: 8,
        range: [16, 128],
    };

    /// A share of the boxes. The size that this share does not exceed is taken for the size of all. Above: a few large boxes
    /// make the strips too wide. Below: more boxes are on a border, or too large for the grid.
    pub(crate) const GRID_SIZE_QUANTILE: f64 = 0.75;

    /// The same for what crowds in a tube, tried in turn. Fewer: what crowds among others crowds in the next grid as well. More: each try is a
    /// pass over the boxes.
    pub(crate) const CROWD_SIZE_QUANTILES: [f64; 3] = [0.375, 0.125, 0.75];

    /// A factor. A box that is so many times longer along the first axis than that size, and than strips are wide, is too large for a grid.
    /// Above: one floor makes all that is looked up on it visit what it spans. Below: more classes.
    pub(crate) const LONG_FROM: f64 = 4.0;

    /// Queries. So few are looked up in another class for certain. Above: walls visit every tube. Below: both classes are tried for a few.
    pub(crate) const FEW_QUERIES: usize = 16;

    /// To find out of which of two classes the boxes are looked up in the other. More: time. Fewer: chance decides.
    pub(crate) const EFFORT_SAMPLE: Sample = Sample {
        one_in: 256,
        range: [16, 64],
    };

    /// Comparisons that a query takes as long as before it visits its first tube. Above: large boxes are looked up among small ones. Below:
    /// small among large ones.
    pub(crate) const QUERY: f64 = 400.0;

    /// Comparisons that visiting a tube takes as long as: its entries are searched for the first to be compared. Above: small boxes are looked
    /// up among large ones. Below: large among small ones.
    pub(crate) const VISIT: usize = 32;

    /// The same of a tube none of whose entries is near along the first axis.
    pub(crate) const PASSED_OVER: usize = 8;

    /// Shares of the boxes. The grid is laid over what lies between these two. Nearer 0 and 1: a few boxes far out make the
    /// strips too wide. Nearer the middle: more boxes lie outside, in the first and in the last strip.
    pub(crate) const GRID_PLACE_QUANTILES: [f64; 2] = [0.02, 0.98];

    /// A factor. So many more strips have tubes of their own than there are between those shares, for boxes outside. Above: more empty
    /// tubes. Below: what lies outside shares tubes with what lies inside.
    pub(crate) const GRID_SPARE: f64 = 1.125;

    /// Box sizes, with one and with two cut axes: the width of a strip. Above: more candidates a box. Below: more boxes on a
    /// border, which are entered twice. Best between 8 and 16, and between 4 and 8.
    pub(crate) const BOXES_PER_STRIP: [f64; 2] = [12.0, 6.0];

    /// Boxes. Strips are wider where tubes would have fewer than these on average. Above: what crowds in some tubes is compared. Below: tubes
    /// of a few boxes, each of which costs more than it saves.
    pub(crate) const BOXES_A_TUBE: f64 = 32.0;

    /// Candidates a box. Strips are narrowed where boxes lie so densely that each would have more: the sweep decides them in
    /// blocks of eight. Above: two blocks a box. Below: more ghosts.
    pub(crate) const CANDIDATES_A_BOX: f64 = 8.0;

    /// How many times narrower strips become, at most, where boxes lie densely. Above: most boxes are on a border. Below: boxes
    /// have more candidates than a block decides.
    pub(crate) const NARROWED_UP_TO: f64 = 4.0;

    /// Boxes a tube, where boxes have no size to choose the width of the strips by. Above: more candidates a box. Below:
    /// tubes of a few points, each of which costs more than it saves.
    pub(crate) const POINTS_A_TUBE: f64 = 16.0;

    /// Comparisons for each entry of a tube, and for each pair among them. With more, the entries crowd: they are searched by a kernel of
    /// their own. Above: crowds are swept. Below: kernels for what a sweep does as fast.
    pub(crate) const COMPARED_AN_ENTRY: usize = 128;
    pub(crate) const COMPARED_A_PAIR: usize = 16;

    /// Entries of a tube. Up to this many are sorted by insertion alone. Above: insertion is quadratic. Below: dealing into
    /// buckets costs more than it saves.
    pub(crate) const INSERTION_UP_TO: usize = 12;

    /// Buckets for each entry of a tube. Above: walking along empty buckets. Below: more entries are left to insertion, and each
    /// is a branch mispredicted.
    pub(crate) const BUCKETS_AN_ENTRY: usize = 2;

    /// Entries of a bucket. With more, the bucket is sorted on its own before insertion. Above: quadratic time where entries
    /// crowd. Below: a call where a few moves would do.
    pub(crate) const CROWDED_BUCKET: u32 = 24;

    /// Slabs, and boxes a slab. Work may be cut into so many slabs, and one more for each so many boxes: a slab has room for about a
    /// hundred entries of its own. Above: threads idle that could share few boxes. Below: memory, if a user asks for very many slabs.
    pub(crate) const SLABS_UP_TO: usize = 16;
    pub(crate) const BOXES_A_SLAB: usize = 64;

    /// Entries of all tables of tubes for each box. Each part of the boxes has a table of its own. Above: memory. Below: where boxes lie
    /// so far apart that there are about as many tubes as boxes, fewer threads deal them into tubes.
    pub(crate) const TABLED_TUBES_A_BOX: u64 = 8;

    /// Boxes. With fewer, `RankSweep` does not sort its two axes at once in two threads. Above: the second thread idles. Below:
    /// waking it takes longer than the sort.
    pub(crate) const SORT_BOTH_AXES_FROM: usize = 1 << 14;
}

/// Pairs over time: the tracker and the proxy table. Shown by `measure -- hard-motions`, and over
/// whole worlds by the example `compare`.
pub(crate) mod update {
    /// Listed colliders. Up to this many are read in the order in which they are listed, because they fit in the caches
    /// in any order; more are read by index. Above: islands make the reads jump around in memory, at twice the time.
    /// Below: a pass over the bits of all slots for a handful.
    pub(crate) const READ_AS_LISTED_UP_TO: usize = 256;

    /// Listed colliders. So many are read by index in whatever order they are listed: they are most of a large world.
    pub(crate) const READ_BY_INDEX_FROM: usize = 1 << 14;

    /// Slots. A box may be handed over for a collider that is not known, and that may not exist. Up to this far beyond all
    /// known slots it is shown to queries at once. Above: a wrong handle takes more memory. Below: a program that hands over
    /// the boxes of a new world in any order, and asks before its first update, does not find them all.
    pub(crate) const ROOM_AHEAD: usize = 1 << 16;

    /// Boxes may be handed over any number of times between two updates. From this many notes a slot on, repeated ones are forgotten.
    /// Above: they take more memory. Below: they are sorted more often.
    pub(crate) const MOST_NOTES_A_SLOT: usize = 4;

    /// Pairs whose boxes overlap and whose volumes do not, for each slot. If there are more, they are asked again only once they may have
    /// moved far enough. Above: bundles of capsules are asked in each update. Below: counting moves takes longer than asking.
    pub(crate) const DUES_FROM: usize = 2;

    /// One slot in this many. If more were touched, all slots are gone through and all candidates compared, in order; if fewer,
    /// only the touched ones are, and their candidates picked. Above: all candidates are compared though few can have turned.
    /// Below: picking costs as much as comparing.
    pub(crate) const COMPARE_ALL_FROM_ONE_IN: usize = 3;

    /// Slots. In worlds of no more, a full search compares each with each: choosing a grid and sorting into it takes longer, and so do
    /// look-ups. Above: the number of comparisons is quadratic.
    pub(crate) const COMPARE_ALL_UP_TO: usize = 16;

    /// Picks from all candidates. Making the lists costs about as much as this many. Above: the lists come late. Below: they
    /// are made, and dropped unused at the next full search.
    pub(crate) const LISTS_COST: u32 = 8;

    /// A part of a full search. There is one if the look-ups of an update cost more by this than the mean of all updates since the
    /// last full search, that run included. Above: waves, fat boxes made at one time and left at one time, are looked up box by box.
    /// Below: full searches for what was chance.
    pub(crate) const FULL_SEARCH_SLACK: u64 = 16;

    /// Boxes or pairs. With more, what only a full search needs is freed after it. Above: half of all memory lies unused in
    /// nine updates of ten. Below: small worlds allocate in every full search.
    pub(crate) const KEEP_SCRATCH_UP_TO: usize = 1 << 12;

    /// One row of the candidates in this many. Once more are tombstones, they are removed. Above: rows are moved, and lists made
    /// again, for a few tombstones. Below: comparing goes through rows that are gone.
    pub(crate) const SPARSE_FROM_ONE_IN: usize = 2;

    /// One slot in this many. A set of more slots is cleared by overwriting all flags. Above: flags of slots that are not in the
    /// set are written. Below: slots of the set are visited one by one, in any order.
    pub(crate) const CLEAR_ALL_FROM_ONE_IN: usize = 4;

    /// One candidate in this many. A full search makes room for so many more than there are. Above: the list of what was found grows
    /// in the midst of the run, and is copied. Below: memory.
    pub(crate) const FOUND_SPARE_ONE_IN: usize = 8;

    /// Candidates for each slot and pair of overlapping boxes. With more, foresight is cut to a quarter: huge boxes are about to pass over
    /// many small ones, say. Above: memory. Below: dense scenes lose their foresight.
    pub(crate) const MOST_CANDIDATES: usize = 8;

    /// Pairs of fat boxes for each slot and pair of overlapping boxes. A search that finds so many more than the last one is given up, and
    /// foresight is cut. Above: memory. Below: a crowd of new boxes is searched twice.
    pub(crate) const MOST_FOUND: usize = 64;
}

/// How far ahead fat boxes are drawn.
pub(crate) mod foresight {
    /// Box sizes: how far ahead fat boxes are drawn, at the mean speed. Above: more candidates where things are fast. Below: more
    /// searches.
    pub(crate) const AHEAD: f64 = 0.5;

    /// Moves. The longest foresight. Above: where things are slow, more candidates than searches are saved. Below: more searches.
    pub(crate) const LONGEST: u16 = 32;

    /// Moves. The foresight while nothing has moved yet. Above: where what moves first is huge, thousands of candidates. Below: what moves
    /// first soon leaves its fat box again.
    pub(crate) const FIRST: u16 = 8;

    /// A part of how far the fat box goes ahead: how far it goes to all sides. Above: more candidates. Below: crowds, whose
    /// members keep turning, leave their fat boxes a third more often.
    pub(crate) const SKIN: f64 = 0.125;

    /// A part of the box's size: the most that the skin may be. Above: more candidates where things are fast. Below: fast things
    /// that turn leave their fat boxes.
    pub(crate) const WIDEST_SKIN: f64 = 0.25;

    /// Proxies that are looked at to learn how fast things move. Above: time. Below: a few outliers decide.
    pub(crate) const SPEED_SAMPLE: usize = 128;

    /// What foresight is divided by when there are too many candidates. Above: foresight that would pay is lost. Below: several
    /// searches until there are few enough.
    pub(crate) const CUT: u16 = 4;

    /// Full searches until what was cut is doubled again. Above: foresight that would pay is lost. Below: too many candidates are found,
    /// and thrown away, again and again.
    pub(crate) const CUT_RUNS: u32 = 16;
}

/// What the units of an update's work cost, in tenths of a nanosecond, in whole worlds where the solver has emptied the
/// caches. Chosen, and not fitted: a fit to the times of updates does not know what they spare or cost later. Ratios decide what an
/// update does; sums decide how many threads share it.
pub(crate) mod prices {
    /// Asking of a candidate whether one of its proxies was touched. Above: lists are walked where picking is faster. Below:
    /// lists are left unused where few move.
    pub(crate) const PICKED: u64 = 10;

    /// Finding the list of a proxy. Above: lists are left unused where few move. Below: lists are walked where picking is faster.
    pub(crate) const LISTED: u64 = 300;

    /// Walking along a list, for each candidate: waiting for memory. Above and below: the same.
    pub(crate) const WALKED: u64 = 50;

    /// Reading a collider, or taking in a box that was handed over: shapes and bodies are anywhere in memory. Above: threads are woken for
    /// little. Below: cores idle.
    pub(crate) const READ: u64 = 300;

    /// Comparing a candidate. Above and below: the same.
    pub(crate) const COMPARED: u64 = 20;

    /// How many times that, and reading, where not all volumes are balls. Above and below: the same.
    pub(crate) const BEYOND_BALLS: u64 = 3;

    /// Finding out whether a found candidate overlaps and was held. Above and below: the same.
    pub(crate) const HELD: u64 = 60;

    /// Inflating, comparing or copying the box of a slot. Above and below: the same.
    pub(crate) const SLOT: u64 = 30;

    /// Looking a box up in a sorted layer, besides what it visits. Above: full searches where a look-up would do. Below: tens of thousands are
    /// looked up one by one.
    pub(crate) const LOOKED_UP: u64 = 5000;

    /// A comparison of a look-up, or as much: few for most boxes, and many for moving walls. Above and below: the same.
    pub(crate) const VISITED: u64 = 4;

    /// A box of a run: drawing, sorting and sweeping. Above: few full searches. Below: many.
    pub(crate) const SEARCHED: u64 = 450;

    /// A candidate found: writing it down, finding out whether it was held, and comparing it for some updates to come. Above: tens of
    /// thousands of boxes are looked up one by one. Below: full searches where look-ups would do.
    pub(crate) const FOUND: u64 = 350;
}

/// When work is shared among threads. In tenths of a nanosecond of work on one thread, by estimates.
pub(crate) mod threads {
    /// Debug builds share less work, so that tests need not be long.
    const SCALE: u64 = if cfg!(debug_assertions) { 16 } else { 1 };

    /// What sharing must spare an update, or a section of one, that begins outside of the pool. Above: cores idle. Below: waking threads,
    /// twice, and caches that are cold, cost more than it saves: some 100 microseconds on a server, and more on a virtual machine.
    pub(crate) const ENTER_COST: u64 = 2_500_000 / SCALE;

    /// What sharing must spare a section of an update that runs in the pool. Above: cores idle. Below: waking the others, 1 to 10
    /// microseconds, costs more than it saves.
    pub(crate) const SECTION_COST: u64 = 200_000 / SCALE;

    /// A part of a section. Above: cores idle. Below: threads are woken for what the others have done before they come.
    pub(crate) const PART_FROM: u64 = 100_000 / SCALE;
}

/// The tree for queries. Shown by `measure -- queries`, and by the example `compare` with `--rays 1`.
pub(crate) mod queries {
    /// Leaves. A tree of no more is built afresh when it loses one, since Parry's trees that lose nearly all leaves are not
    /// sound, and its leaves keep their places: all of it can be visited in no time.
    pub(crate) const SMALL_UP_TO: u32 = 16;

    /// Updates. A tree that has not been asked for in this many is given up. Above: scenes that have stopped asking go
    /// on noting what has changed. Below: a program that asks now and then builds a tree each time.
    pub(crate) const KEEP_UNASKED: u32 = 64;

    /// One leaf in this many. If fewer were renewed, each is written alone, with what becomes of its ancestors; otherwise all
    /// nodes are computed anew. Above: a pass over the whole tree for a few leaves. Below: ancestors are written many times.
    pub(crate) const FEW_UP_TO_ONE_IN: usize = 8;

    /// One leaf in this many. Once more have been written alone or removed, the nodes are put in order, which tightens ancestors and
    /// frees what removed leaves have left. Above: time. Below: rays visit more of the tree.
    pub(crate) const TIGHTEN_FROM_ONE_IN: usize = 2;

    /// One leaf in this many. Once more have left the boxes for which their places were chosen, of many that were written at a time, the
    /// tree is judged by its girth. Above: time. Below: the tree ages before it is noticed.
    pub(crate) const JUDGE_FROM_ONE_IN: usize = 4;

    /// Leaves that are looked at for that. Above: time. Below: chance decides.
    pub(crate) const STRAY_SAMPLE: usize = 64;

    /// Units of 2^-20 octaves. If the girth has grown by more since the tree was built, it is built afresh. Above: the tree
    /// ages, and rays visit more of it. Below: building takes more than rays save.
    pub(crate) const BUILD_FROM_GIRTH: u64 = 1 << 20;
}
