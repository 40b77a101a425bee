"""Call graphs as gcc writes them (-fcallgraph-info=su): cycles and the deepest stack.

A function with external linkage has its own name, a static one is called file:name, as in gcc's .ci files.
"""
import re

NODE = re.compile(r'node: { title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: { sourcename: "([^"]+)" targetname: "([^"]+)"')
INDIRECT = "__indirect_call"
# B of functions of libgcc 12 and newlib on Cortex-M, which push seven and five words; for others deepest() gets a
# value.
OUTSIDE = {"__aeabi_lmul": 40, "__clzsi2": 8, "memcpy": 40, "memset": 40}
# B that assembly in a function pushes, on an M0+ (core/triangle/thumb_runs.h).
PUSHED = {"sheen_linear_rows": 12, "sheen_wide_shades_rows": 12}
# Which functions the indirect calls of the core reach, through pointers in sheen_shader, sheen_edges, sheen_clipper,
# line_kind, sheen_ramp_reader, sheen_fog_mixer, sheen_morpher, sheen_points and arc_row: (callers, functions called).
# Without this, each call could reach every function whose address is taken.
SHADER_CALLS = [(r"(^|:)sheen_draw$", r"(_light|_begin|_shades_of|edges_list|morph_fits|cut_triangle|list_quad|most_warp)$"),
                (r"(^|:)begin_(colours|draw)(\.isra\.\d+)?$", r"(_light|_begin|_shades_of|begin_by_ramp|fog_draw|most_warp)$"),
                (r"(^|:)sheen_entry_corners$", r"(^|:)(piece|quad)_corners$"),
                (r"(^|:)object_problem$", r"(morph_fits|_valid)$"),
                (r"(^|:)sheen_bin_rollback$", r"edges_cover$"),
                (r"(^|:)(edges_draw|draw_all_lines|draw_lines_of)$", r"(^|:)(draw_lines|draw_smooth|sheen_smooth_finish)$"),
                (r"(^|:)(draw_lines|fogged_line)$", r"fogged_line_run$"),
                (r"(^|:)sheen_band$", r"edges_(begin|draw)$"),
                (r"(^|:)view_begin$", r"fog_begin$"),
                (r"(^|:)(sheen_use_corners|corner_point)$", r"morph_position$"),
                (r"(^|:)sheen_light_corners$", r"_light$|morph_normal$"),
                (r"(^|:)draw_triangles?$", r"_light$|morph_normal$|cut_triangle$|list_quad$"),
                (r"(^|:)clip_triangle$", r"cut_triangle$"),
                (r"(^|:)cut_triangle$", r"_(light|carry)$|morph_cut$"),
                (r"(^|:)(cut_parts|list_pieces|light_triangle)$", r"_(light|carry)$"),
                (r"(^|:)set_up$", r"_setup$|morph_corners$"),
                (r"(^|:)sheen_glow_begin$", r"points_place$"),
                (r"(^|:)sheen_light_tinted$", r"points_beam$"),
                (r"(^|:)sheen_polygon_glow$", r"_light_by_ramp$|morph_facet$|points_middle$"),
                (r"(^|:)(sheen_facet_(lit|normal)|flat_colored_carry)$", r"_light_by_ramp$|morph_facet$"),
                (r"(^|:)(sheen_light_back|sheen_vertex_glow)$", r"_light_by_ramp$|morph_(normal|position)$"),
                (r"(^|:)(light_normal|sheen_setup_mean_normal|\w*_(light|carry))$", r"_light_by_ramp$"),
                (r"(^|:)(morph_(cut|corners)|position_of|normal_of|points_middle|sheen_shared_normals)$", r"morph_(position|normal)$"),
                (r"(^|:)sheen_shaded_run$", r"(general_run|_shaded_run_by_ramp|fogged_shaded_run)$"),
                (r"(^|:)sheen_textured_run$", r"(any_run|fogged_texel_run)$"),
                (r"(^|:)(draw_normal_run|sheen_phong_lights_rows|draw_normals)$", r"(sheen_normal_run|_normal_run_by_ramp|fogged_normal_run)$"),
                (r"(^|:)(sheen_slerp_draw|draw_row)$", r"(^|:)(lit_parts|sheen_slerp_normal_parts|draw_(lit|normals))$"),
                (r"(^|:)(sheen_slerp_draw|draw_row) for tinted$", r"(^|:)(sheen_slerp_normal_parts|draw_tinted)$"),
                (r"(^|:)(draw_rows|draw_entry|draw_pending|draw_and_push|sheen_band)$", r"_(setup|rows(_\w+)?|hide)$|morph_corners$"),
                (r"(^|:)texel_values_at", r"texel_of_unit$"),
                (r"(^|:)(paint(\.isra\.\d+)?|collect_push|push_tile|lock|unlock|sheen_(wait|claim_band|free_buffer|send_tile))$",
                 r"(?!)")]  # callbacks of the user

# A function that calls functions handed to it, together with those that it may be inlined into, is copied under another
# name for callers that hand it other functions: (functions, callers, suffix of the copies).
HANDED = [(r"(^|:)(sheen_slerp_draw|draw_row)$", r"(^|:)tinted_slerp_rows$", " for tinted")]


class CallGraph:
    def __init__(self, ci_files):
        self.stack = {}      # function -> bytes of its own frame
        self.dynamic = []    # functions whose frame has no fixed size
        self.calls = {}      # function -> called names, in order
        for path in ci_files:
            with open(path, encoding="utf-8") as ci:
                self._read(ci)

    def _read(self, lines):
        for line in lines:
            if node := NODE.match(line):
                self._add_node(*node.groups())
            elif edge := EDGE.match(line):
                self.calls.setdefault(edge[1], []).append(edge[2])

    def _add_node(self, name, label):
        frame = re.search(r"(\d+) bytes \(([a-z,]+)\)", label)
        if frame:            # nodes without a frame are functions defined elsewhere
            self.stack[name] = int(frame[1]) + PUSHED.get(name, 0)
            if frame[2] != "static":
                self.dynamic.append(name)

    def resolve_indirect(self, taken, kinds=()):
        """Lets an indirect call reach every function whose address is taken (all names in `taken`).

        kinds: (pattern of callers, pattern of what their indirect calls reach) restricts that for the callers that
        match. A caller that matches several kinds, because the compiler merged functions, reaches what all of them do.
        """
        reached = [name for name in self.stack if name.rsplit(":", 1)[-1] in taken]
        for group, caller, suffix in HANDED:
            for name in [name for name in self.calls if re.search(caller, name)]:
                self.calls[name] = [self._copy(called, group, suffix) for called in self.calls[name]]
        callers = {name for name, called in self.calls.items() if INDIRECT in called}
        self.calls[INDIRECT] = reached
        for caller in callers:
            nodes = [callees for pattern, callees in kinds if re.search(pattern, caller)]
            for callees in nodes:
                self.calls[f"{INDIRECT} {callees}"] = [name for name in reached if re.search(callees, name)]
                self.stack[f"{INDIRECT} {callees}"] = 0
            if nodes:
                self.calls[caller] = [name for name in self.calls[caller] if name != INDIRECT]
                self.calls[caller] += [f"{INDIRECT} {callees}" for callees in nodes]

    def _copy(self, name, group, suffix):
        """Copies a function of the group, and those of the group that it calls; returns the name of the copy. The name
        of any other function is returned as it is."""
        if not re.search(group, name):
            return name
        if name + suffix not in self.stack:
            self.stack[name + suffix] = self.stack[name]
            self.calls[name + suffix] = [self._copy(called, group, suffix) for called in self.calls.get(name, ())]
        return name + suffix

    def cycles(self):
        """A list of cycles, one for each back edge found; each is the list of its functions."""
        found, done = [], set()

        def visit(name, path):
            if name in path:
                found.append(path[path.index(name):] + [name])
                return
            if name in done:
                return
            for callee in self.calls.get(name, ()):
                visit(callee, path + [name])
            done.add(name)

        for name in self.stack:
            visit(name, [])
        return found

    def deepest(self, outside):
        """(bytes, chain of names) of the deepest stack; a function defined elsewhere counts as `outside` bytes.

        The graph must not have cycles. Indirect calls to anything but the targets of resolve_indirect() are callbacks
        of the user and are not counted.
        """
        known = {}

        def depth(name):
            if name not in known:
                below = max((depth(callee) for callee in self.calls.get(name, ())), default=(0, []))
                own = 0 if name == INDIRECT else self.stack.get(name, OUTSIDE.get(name, outside))
                known[name] = (own + below[0], [name] + below[1])
            return known[name]

        return max((depth(name) for name in self.stack), default=(0, []))
