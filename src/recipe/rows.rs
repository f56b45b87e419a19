//! The rows of the table of parameters: the one place where a parameter is named, ranged, explained and given its default.
//!
//! Links, attributes, command-line options, JSON, the page's controls and `docs/parameters.md` all come from here.
//! Keys are added freely and never renamed: a shared link holds them.

/// Hands the rows to a macro: groups with their headings, and in each its rows, a help text and then
///
/// ```text
/// Key = "name in links", "Label": Stage, Kind(range, default, logarithmic), in "unit", with MORE_HELP;
/// ```
///
/// `logarithmic`, unit and more help are optional.
macro_rules! rows {
    ($then:ident) => {
        $then! {
            "Seed" {
                /// The word that the country grows from: any text.
                Seed = "seed", "Seed": Land, Text(to 64, default "kauri");
                /// The set of algorithms that draws the recipe. Once an edition is released, its pictures never change.
                Edition = "edition", "Edition": Land, Integer(EDITION to EDITION, default EDITION);
            }
            "Land" {
                /// The kind of country. It decides the values of land, growth, rivers, relief, climate and woods that are left out. By
                /// default, the word draws a kind, and its own values within it.
                Country = "country", "Country": Paint, Choice(Country);
                /// Width of the map over its height. The area is always a million square units.
                Aspect = "aspect", "Aspect": Land, Number(0.25 to 4.0 by 0.01, default 1.6, logarithmic);
                /// Width of the map in kilometres. The scale bar, lengths, heights, contours, data files, and words such as Brook or
                /// River in names follow it.
                Span = "span", "Span": Name, Number(10.0 to 5000.0 by 1.0, default 200.0, logarithmic), in "km";
                /// The shape of the land that rivers run through.
                Land = "land", "Land": Land, Choice(LandKind);
                /// The coasts, ridges and rivers of a drawn land. Without a coast, the whole rectangle is land.
                Outline = "outline", "Outline": Land, Outline();
                /// Share of the map that is water. 0: the share that suits the land (an island 0.72, a coast 0.35). No effect if the
                /// land is drawn or is the whole rectangle.
                Sea = "sea", "Sea": Land, Number(0.0 to 0.8 by 0.01, default 0.0);
                /// How far the sea has risen into valleys that rivers cut before. 0: coasts as they are shaped. High values
                /// make long inlets, headlands and islets; the share of water stays.
                Drowning = "drowning", "Drowning": Land, Number(0.0 to 1.0 by 0.02, default 0.24);
                /// Irregularity of coasts and ridges: 0 for smooth lines, 1 for wild ones.
                Roughness = "roughness", "Roughness": Land, Number(0.0 to 1.0 by 0.01, default 1.0);
                /// Number of rivers that reach the sea. A lake or a gulf has three times as many, and every larger island has
                /// at least one. 0: 8, or every outlet with drainage.
                Mouths = "mouths", "River mouths": Grow, Integer(0 to 64, default 0, logarithmic);
                /// Minimum distance between river mouths along a coast. A large distance means fewer mouths.
                MouthSpacing = "mouth-spacing", "Distance between mouths": Grow, Number(0.0 to 400.0 by 5.0, default 0.0),
                    in "units";
                /// Sides of the map where the sea is. Applies to the rectangle, a coast and a valley; the water of other lands
                /// is fixed.
                Sides = "sides", "Sea on": Land, Sides(default SOUTH);
                /// Directions in which river mouths may lie, seen from the middle of the coast.
                Shores = "shores", "Mouths on": Grow, Sides(default ALL);
            }
            "Growth" {
                /// Growth method: water drains the land, attractors pull rivers (space colonization), or wandering particles
                /// form a Brownian tree.
                Growth = "growth", "Growth": Grow, Choice(GrowthMethod);
                /// Smallest step of a Brownian tree: about the distance between neighbouring streams.
                Sensitivity = "sensitivity", "Sensitivity": Grow, Integer(8 to 64, default 16, logarithmic), in "units";
                /// Number of attractors; with drainage, of parcels on land, if the sea is as it suits the land. More make a
                /// finer network.
                Attractors = "attractors", "Attractors": Grow, Integer(100 to 1_000_000, default 20_000, logarithmic);
                /// Placement of attractors: at random, or one in each cell of a grid, which makes an even network.
                Scatter = "scatter", "Scatter": Grow, Choice(Scatter);
                /// Distance from which attractors pull. Small: winding rivers. Large: straight ones.
                Reach = "reach", "Reach": Grow, Number(2.1 to 12.0 by 0.05, default 2.3, logarithmic), in "spacings";
                /// Attractors are removed once a river comes this close. Smaller values make many short streams.
                Kill = "kill", "Kill distance": Grow, Number(0.5 to 1.4 by 0.05, default 1.1), in "spacings";
                /// Length by which a river grows in one tick.
                Step = "step", "Step": Grow, Number(0.2 to 1.2 by 0.01, default 0.38), in "spacings";
            }
            "Bends" {
                /// Exaggerates each turn by subtracting this share of the previous direction. Rivers zigzag from 0.5 on.
                Momentum = "momentum", "Momentum": Grow, Number(0.0 to 0.9 by 0.01, default 0.0);
                /// Maximum random turn of each step. The side alternates every 'stretch' nodes; with valleys it is random, from
                /// place to place.
                Curl = "curl", "Curl": Grow, Number(0.0 to 2.0 by 0.01, default 0.7), in "radians";
                /// Number of nodes for which a river curls to one side before it turns to the other; with valleys, how large
                /// the places are that have a side of their own.
                Stretch = "stretch", "Stretch": Grow, Integer(1 to 64, default 8, logarithmic), in "nodes";
            }
            "Drainage" {
                /// Influence of deep valleys on where water goes: 0 for calm, map-like networks, 1 for wild ones. At 0, space
                /// colonization is as in the paper.
                Valleys = "valleys", "Valleys": Grow, Number(0.0 to 1.0 by 0.01, default 0.2);
                /// Approximate distance between large valleys.
                ValleySpacing = "valley-spacing", "Distance between valleys": Grow, Number(4.0 to 60.0 by 0.5, default 32.0, logarithmic),
                    in "spacings";
                /// Rate at which rivers flatten downstream. The flatter large rivers are, the more water they draw.
                Concavity = "concavity", "Concavity": Grow, Number(0.2 to 0.8 by 0.01, default 0.5);
                /// Number of rounds in which streams capture one another before they settle.
                Captures = "captures", "Rounds of capture": Grow, Integer(0 to 24, default 5), in "rounds";
                /// Contrast between hard and soft ground. Rivers avoid hard ground.
                Hardness = "hardness", "Hardness": Grow, Number(0.0 to 1.5 by 0.01, default 0.4);
                /// Approximate distance between areas of hard ground.
                HardnessScale = "hardness-scale", "Size of hard ground": Grow, Number(8.0 to 60.0 by 0.5, default 36.0, logarithmic),
                    in "spacings";
                /// Distance by which the land is bent, and rivers with it.
                Bending = "bending", "Bending": Grow, Number(0.0 to 4.0 by 0.05, default 2.8), in "spacings";
                /// Variation of the bending from place to place: 0 for the same everywhere, higher for straight reaches beside
                /// wild bends.
                BendingVariation = "bending-variation", "Uneven bending": Grow, Number(0.0 to 2.0 by 0.05, default 0.5);
                /// Pattern of drainage: the lie of beds, joints and slopes that rivers follow.
                Pattern = "pattern", "Pattern": Grow, Choice(Pattern);
                /// Direction of folded beds and of joints, clockwise from north; an even slope falls across it. 0: drawn from the
                /// seed.
                Strike = "strike", "Strike": Grow, Integer(0 to 180, default 0), in "degrees";
                /// Place of the high or low ground that rivers run from, around or to, and of a lake or a gulf, as a share of
                /// the map's width. 0: drawn from the seed.
                CenterX = "center-x", "Centre, from the west": Land, Integer(0 to 100, default 0), in "%";
                /// Place of the high or low ground that rivers run from, around or to, and of a lake or a gulf, as a share of
                /// the map's height. 0: drawn from the seed.
                CenterY = "center-y", "Centre, from the north": Land, Integer(0 to 100, default 0), in "%";
                /// Pull of the land's general slope, most of it toward the sea. High values draw rivers side by side and narrow
                /// the angles at which they join.
                Fall = "fall", "Fall": Grow, Number(0.0 to 2.0 by 0.05, default 0.35);
                /// Number of parcels that must drain before a river begins. Smaller areas make a denser network.
                ChannelArea = "channel-area", "Channel area": Prune, Integer(1 to 60, default 3, logarithmic), in "parcels";
                /// Variation of the channel area from place to place: dense streams here, few there.
                HeadVariation = "head-variation", "Uneven channel heads": Prune, Number(0.0 to 1.0 by 0.05, default 0.5);
            }
            "Finish" {
                /// Side branches shorter than this are removed. The longest branch of every fork stays.
                Trim = "trim", "Trim": Prune, Number(0.0 to 400.0 by 1.0, default 18.0), in "units";
                /// Variation of the length below which side branches are removed, from branch to branch.
                TrimVariation = "trim-variation", "Uneven trim": Prune, Number(0.0 to 1.0 by 0.05, default 0.3);
                /// Tributaries that join closer to a greater one are removed, and those that run close beside another river. 0:
                /// none.
                TributarySpacing = "tributary-spacing", "Distance between tributaries": Prune,
                    Number(0.0 to 6.0 by 0.1, default 1.6), in "spacings";
            }
            "Rivers" {
                /// The lines that rivers follow: smooth, or the tree's own steps with every sharp turn.
                Courses = "courses", "Courses": Shape, Choice(CourseShape);
                /// Share of each course's points to remove, the least important first. Confluences stay.
                Simplify = "simplify", "Simplify": Shape, Number(0.0 to 95.0 by 1.0, default 35.0), in "%";
                /// Width of a river that would drain the whole map. Other widths follow the square root of discharge.
                Width = "width", "Width": Shape, Number(1.0 to 40.0 by 0.5, default 16.0, logarithmic), in "units";
                /// Variation of the width along a river, as a share of the width. The two banks vary independently.
                BankVariation = "bank-variation", "Uneven banks": Shape, Number(0.0 to 0.5 by 0.01, default 0.15);
                /// Sediment that great rivers carry. It fills drowned valleys from their heads on, then builds deltas into the
                /// sea. 0: none; each half more is ten times as much.
                Deltas = "deltas", "Deltas": Shape, Number(0.0 to 1.0 by 0.02, default 0.0);
                /// Strength of waves at the mouths of rivers. 0: deltas like a bird's foot, 1: with a smooth front.
                Waves = "waves", "Waves": Shape, Number(0.0 to 1.0 by 0.05, default 0.4);
            }
            "Meanders" {
                /// Model of meandering: each bend moves by its own curvature, by the curvature upstream as well, or not at all.
                Meander = "meander", "Meanders": Shape, Choice(MeanderModel);
                /// Duration of meandering. Bends grow, necks are cut off, and oxbow lakes stay behind.
                MeanderRounds = "meander-rounds", "Meander time": Shape, Integer(0 to 400, default 18), in "rounds";
                /// Distance that bends move in each round.
                MeanderStrength = "meander-strength", "Strength": Shape, Number(0.0 to 1.0 by 0.01, default 0.6);
                /// Direction in which bends move: 1 is outward only, 0 is downstream only.
                MeanderMix = "meander-mix", "Outward or downstream": Shape, Number(0.0 to 1.0 by 0.01, default 0.6);
                /// Amount of meandering of all other rivers, which varies from place to place.
                MeanderElsewhere = "meander-elsewhere", "Meandering of other rivers":
                    Shape, Number(0.0 to 1.0 by 0.01, default 0.3);
                /// Number of rivers that meander fully where they are flat.
                GreatRivers = "great-rivers", "Great rivers": Shape, Integer(0 to 16, default 3);
                /// Share of all river length that counts as flat, the flattest first. The great rivers meander fully there.
                FlatShare = "flat-share", "Flat share": Shape, Number(0.0 to 1.0 by 0.01, default 0.2);
                /// Distance between the two limbs of a loop at which the river cuts through.
                Neck = "neck", "Neck": Shape, Number(1.0 to 4.0 by 0.1, default 1.5), in "widths";
                /// How long oxbow lakes last: 0 leaves none, 1 all that are cut off. Rivers that come back take them.
                Oxbows = "oxbows", "Oxbow lakes": Shape, Number(0.0 to 1.0 by 0.01, default 0.5);
                /// Distance that the banks of two rivers keep from each other. Bends that come closer stop moving.
                Clearance = "clearance", "Clearance": Shape, Number(0.0 to 1.0 by 0.01, default 0.15), in "spacings";
                /// Distance from sources, mouths and confluences over which meandering sets in.
                Taper = "taper", "Taper": Shape, Number(1.0 to 20.0 by 0.5, default 6.0), in "widths";
            }
            "Relief" {
                /// Steepness of the land far from the sea. Rivers stay where they are.
                Mountains = "mountains", "Mountains": Relief, Number(0.2 to 4.0 by 0.1, default 2.0);
                /// Distance from the coast over which slopes steepen: plains by the sea, mountains behind.
                Plains = "plains", "Plains": Relief, Number(0.0 to 400.0 by 5.0, default 100.0), in "units";
                /// How deeply brooks too small to draw carve the hillsides into spurs and valleys.
                Rills = "rills", "Rills": Relief, Number(0.0 to 1.0 by 0.05, default 0.6);
                /// Share of the land that is under lakes along rivers: an eighth of it at 1. Rivers run through them.
                Lakes = "lakes", "Lakes": Relief, Number(0.0 to 1.0 by 0.05, default 0.0);
                /// Exaggeration of slopes in shading.
                Shade = "shade", "Shade": Paint, Number(0.0 to 1.0 by 0.05, default 0.45);
            }
            "Climate" {
                /// Warmth. 0: snow nearly down to the plains, and trees only there; 0.5: temperate. Above 0.5 only the tree line rises.
                Warmth = "warmth", "Warmth": Name, Number(0.0 to 1.0 by 0.01, default 0.5), with style::CLIMATE;
                /// Rain. 0: desert, 0.5: temperate, 1: rain forest. Where there are woods, more rain makes more marshes.
                Rain = "rain", "Rain": Name, Number(0.0 to 1.0 by 0.01, default 0.5), with style::CLIMATE;
                /// How much drier land in the lee of ranges is than land on their windward side. 0: the same everywhere; 1: the
                /// greatest difference.
                RainShadow = "rain-shadow", "Rain shadow": Name, Number(0.0 to 1.0 by 0.05, default 0.0);
                /// Direction that the rain comes from, clockwise from north; 360 is north. 0: drawn from the seed.
                Wind = "wind", "Wind from": Name, Integer(0 to 360, default 0), in "degrees";
                /// What the land consists of.
                Ground = "ground", "Ground": Paint, Choice(GroundKind), with style::CLIMATE;
            }
            "Finish" {
                /// Style of the picture.
                Style = "style", "Style": Paint, Choice(Style), with style::RELIEF;
            }
            "Names" {
                /// Share of the land that names may cover, the greatest rivers first.
                Labels = "labels", "Labels": Name, Choice(Labels), with style::MARKS;
                /// Scale of label text. Larger text leaves room for fewer labels.
                LabelSize = "label-size", "Size of letters": Name, Number(0.5 to 2.0 by 0.05, default 1.0, logarithmic);
                /// The made-up language of names. 0 is the seed's own; any other number is the same language for all seeds.
                Language = "language", "Language": Name, Integer(0 to 999, default 0);
                /// Your own names for up to 40 things, such as 12.Silver Water_t.Home.
                Names = "names", "Own names": Name, Text(to 1200, default "");
                /// The map's title and a scale, in a frame, or over a plate: the lengths of the longest rivers, or the profile
                /// of the greatest.
                Cartouche = "cartouche", "Cartouche": Name, Choice(Cartouche);
            }
            "Scenery" {
                /// Share of the land that is wooded. Marshes and rows of trees lie along great rivers. Trees keep clear of
                /// rivers and names.
                Woods = "woods", "Woods": Name, Number(0.0 to 1.0 by 0.01, default 0.0);
                /// Density of hills on divides and, in styles with relief, of mountains on high land.
                Hills = "hills", "Hills": Name, Number(0.0 to 1.0 by 0.01, default 0.0), with style::HILLS;
            }
        }
    };
}

pub(super) use rows;
