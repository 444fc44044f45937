"""A campaign file as tables and labelled arrays. Which dataset holds what: docs/campaign_file.md."""

import html
import os
from functools import cached_property
from typing import Any

import numpy
import pandas
import xarray

from . import program, tables
from .configuration import Configuration
from .intervals import mean_interval
from .quantities import with_times
from .stored import CampaignError, Stored


class Campaign:
    """An open campaign file. Units are SI; quantities and keys have the names that floes gives them.

    A member that failed, or is not computed yet, is NaN in every table. Tables are copies: change them freely.
    During a run the file is replaced again and again; an open one stays as it was.
    """

    def __init__(self, path: str | os.PathLike):
        self._stored = Stored(path)
        self.path = self._stored.path
        self.layout = self._stored.layout  # (major, minor) of docs/campaign_file.md
        self.title = str(self._stored.attributes.get("title"))
        self.fingerprint = str(self._stored.attributes.get("fingerprint"))  # equal if all members are the same

    def __enter__(self) -> "Campaign":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Nothing more can be read; tables that were taken stay."""
        self._stored.close()

    def __repr__(self) -> str:
        if self._stored.closed:
            return f"<campaign {self.title}, closed>"
        status = self._members.status
        done, failed = ((status == word).sum() for word in ("done", "failed"))
        cases = f"{len(self._cases)} case" + ("s" if len(self._cases) != 1 else "")
        return f"<campaign {self.title}: {len(status)} members in {cases}, {done} done, {failed} failed>"

    def _repr_html_(self) -> str:
        """What a notebook shows of it: how many members there are, and a line for each case."""
        about = f"<p>{html.escape(repr(self).strip('<>'))}</p>"
        return about if self._stored.closed else about + self._headlines().to_html()

    # -- members and cases

    @property
    def members(self) -> pandas.DataFrame:
        """A row for each member, by its number: `case` (name), `arrangement` (members of equal ones start from the
        same floes), `arrangement_number`, `status` ("done", "failed", "missing"), `steady` (True, False, NA),
        `reason` of a failure, and every quantity, also of the averaged load ("mean_maximum_0.5s"). Units:
        `quantities`."""
        return self._members.copy()

    @property
    def quantities(self) -> pandas.DataFrame:
        """A row for each quantity of `members`, by its key: `units`, `long_name`, `averaging_time` (s; 0: every
        step)."""
        return self._quantities.copy()

    @property
    def cases(self) -> pandas.DataFrame:
        """A row for each case, by its name: the conditions of its loads (SI units; laws in words), and how many of
        its `members` are `done`, `failed`, `missing`, and done but `not_steady`."""
        cases, members = self._cases.copy(), self._members
        chosen = {"members": members.status != "", "not_steady": (members.steady == False).fillna(False)}  # noqa: E712
        chosen |= {status: members.status == status for status in ("done", "failed", "missing")}
        for name in ("members", "done", "failed", "missing", "not_steady"):
            counts = members.case[chosen[name].astype(bool)].value_counts()
            cases[name] = counts.reindex(cases.index, fill_value=0).astype(int)
        return cases

    @property
    def complete(self) -> bool:
        """Whether every member is done or has failed."""
        return not (self._members.status == "missing").any()

    @property
    def configuration(self) -> dict[str, Any]:
        """The resolved configuration as its TOML tables."""
        return self._configuration.tables

    def keys(self, case: str) -> dict[str, Any]:
        """Every key of the case with its value: {"ice.thickness_m": 0.033, …}. The unit ends the key's name."""
        return self._configuration.keys(self._checked(case))

    @property
    def overrides(self) -> pandas.DataFrame:
        """In what the cases differ: a row for each case, a column for each key that has more than one value."""
        return self._configuration.overrides()

    @property
    def design(self) -> pandas.DataFrame | None:
        """A row for each case of a `[design]`: `base` (the case that was laid out, if there was one), `point`, and
        its value on each axis by key. None without a design."""
        return self._configuration.design()

    # -- loads

    def history(self, member: int) -> xarray.Dataset:
        """`surge_load`, `sway_load` and `heave_load`, N, of a done member over `time`, s since the tow began, to the
        end of the window; of a structure that gives way or goes along a path its motion and what holds it as well
        (`surge_offset`, `surge_mooring` and others of /history). Attributes: `case`, `arrangement`, and
        `steady_start`, where the window begins, s."""
        if member not in self._members.index:
            raise CampaignError(f"There is no member {member}; {self.path} has {len(self._members)}, from 0.")
        row = self._members.loc[member]
        if row.status != "done":
            why = f"failed: {row.reason}" if row.reason else "is missing"
            raise CampaignError(f"Member {member} has no history: it {why}.")
        found = self._histories([member], row.case).isel(member=0, drop=True)
        return found.assign_attrs(member=member, arrangement=int(row.arrangement))

    def histories(self, case: str) -> xarray.Dataset:
        """The same of all done members of a case, over `member` and `time`."""
        done = (self._members.case == self._checked(case)) & (self._members.status == "done")
        return self._histories(self._members.index[done].tolist(), case)

    @property
    def averaged(self) -> xarray.Dataset | None:
        """The surge load averaged over `averaging_time`, s: SD, maxima and peaks of each member, N. None if no case
        has any. `members` has the single numbers too."""
        return self._of_members("averaged")

    @property
    def peaks(self) -> pandas.DataFrame:
        """The peaks of the averaged load, one a row, the highest of a member first: `member`, `case`,
        `averaging_time` (s), `load` (N)."""
        loads = self._stored.read("averaged/peaks") if self._stored.has("averaged/peaks") else numpy.empty((0, 0, 0))
        member, time, _ = numpy.nonzero(numpy.isfinite(loads))
        times = numpy.array(tables.averaging_times(self._stored), float)
        return pandas.DataFrame({"member": member, "case": self._members.case.to_numpy()[member],
                                 "averaging_time": times[time], "load": loads[numpy.isfinite(loads)]})

    @property
    def exceedance(self) -> xarray.Dataset | None:
        """How often the surge load of each member is above each `level`, N: `steps_above` and `upcrossings` in its
        window, `time_above` (a share of the window) and `upcrossings_per_s`. None if no case counts any."""
        found = self._of_members("exceedance")
        if found is None:
            return None
        cases = self._cases.loc[self._members.case]
        window = xarray.DataArray(cases.window.to_numpy(), dims="member")
        step = xarray.DataArray(cases.time_step.to_numpy(), dims="member")
        above, rises = found.steps_above * step / window, found.upcrossings / window
        return found.assign(time_above=above.assign_attrs(units="1", long_name="share of the window above the level"),
                            upcrossings_per_s=rises.assign_attrs(units="s-1", long_name="rises through the level"))

    @property
    def load_map(self) -> xarray.Dataset | None:
        """Where on the structure (`height`, a share of its depth from the keel, and `angle`, degrees, 0 ahead) and
        when along the tow (`tow`, a share of the window) the mean load of each member acts, N. None before layout
        1.7."""
        return self._of_members("load_map")

    # -- ice and how it was computed

    @property
    def breaks(self) -> pandas.DataFrame:
        """Every failed joint of the done members: `member`, `case`, `time` (s since the tow began), `floe`, `joint`
        of the floe, and `mode` in a word ("bending")."""
        return self._listed("breaks")

    @property
    def pieces(self) -> pandas.DataFrame | None:
        """Every piece of the floes that cracked through: `member`, `case`, `floe` and its `area`, m². None before
        layout 1.13."""
        return self._listed("pieces") if "pieces" in self._stored.names() else None

    @property
    def provenance(self) -> dict[str, Any]:
        """How the file was made: versions, compiler, machine, seed, date."""
        return self._stored.attributes | self._stored.attributes_of("provenance")

    @property
    def sessions(self) -> pandas.DataFrame:
        """A row for each start of the program on the campaign: when, where, on how many ranks and threads, how it
        ended."""
        return tables.table(self._stored, "provenance", "session_")

    @property
    def costs(self) -> pandas.DataFrame:
        """What each member took, by its number: `wall_time` and `cpu_time`, s, `peak_memory`, byte, `rank`, `host`,
        `attempts`."""
        names = [name for name in self._stored.names("provenance") if not name.startswith(("session", "configuration", "piece"))]
        columns = {name: self._stored.array(f"provenance/{name}").values for name in names if name != "member"}
        return pandas.DataFrame(columns, self._members.index)

    def group(self, name: str) -> xarray.Dataset:
        """Any group of the file as it stands, with its coordinates: "arrangements" has where each floe lay at the
        start."""
        return self._stored.group(name)

    # -- statistics

    def summary(self, confidence: float = 0.95) -> pandas.DataFrame:
        """What `floes summarize` says of the cases, by (case, quantity): `units`; `n`, the arrangements with a value;
        `estimate`, the mean over them; `low` and `high`, the confidence interval of that mean by Student's t;
        `prediction_low` and `prediction_high`, the prediction interval of one further run. Where members stand out, the
        program gives intervals of a mixture instead (docs/statistics.md). NaN where undefined. Until
        the campaign is `complete` the figures are biased towards short runs. A quantity that an older layout does not
        have has no row. Comparisons of cases: `pairs`."""
        shown = [one for one in with_times(tables.averaging_times(self._stored)) if one.key in self._quantities.index]
        rows = {}
        for case in self._cases.index:
            done = self._members[(self._members.case == case) & (self._members.status == "done")]
            for one in shown:
                found = mean_interval(done[one.key], confidence, one.positive).within(one.least, one.most)
                rows[case, one.key] = {"units": self._quantities.units[one.key],
                                       "n": int(numpy.isfinite(done[one.key]).sum()), **found._asdict()}
        index = pandas.MultiIndex.from_tuples(list(rows), names=["case", "quantity"])
        return pandas.DataFrame(list(rows.values()), index)

    def pairs(self, reference: str | None = None, **options: Any) -> pandas.DataFrame:
        """Cases compared arrangement by arrangement, by the program (`floes summarize --parts pairs`): a row for each
        `quantity` of each pair (`first`, `second`) with the `difference`, its interval `difference_low` to
        `difference_high`, and p of the t test and of Wilcoxon's, adjusted over the pairs (`t_p_holm`,
        `wilcoxon_p_holm`). With a `reference` case, only its pairs. `options`: as on the command line
        (resolve=5)."""
        if reference is not None:
            self._checked(reference)
        found = program.ask("summarize", self.path, parts="pairs", reference=reference, **options)
        rows = pandas.DataFrame(found["pairs"])
        return rows if reference is None or rows.empty else rows[rows["first"] == reference].reset_index(drop=True)

    def design_loads(self, **options: Any) -> pandas.DataFrame:
        """The largest load in an exposure, by the program (`floes design`): a row for each case, method and figure.
        `options` as on the command line: exposure_h=10, quantile=[0.5, 0.9], averaging_s=2, scale=36,
        of="mooring_force". A case that has none, such as one whose load still rises, has the same rows by "both tails"
        with NaN, and the `reason` in words."""
        loads = pandas.DataFrame(program.ask("design", self.path, **options)["design"]["loads"])
        values = loads.columns[loads.columns.get_loc("unit") + 1:-1]  # load and interval: NaN, also where all are
        return loads.astype(dict.fromkeys(values, float)).assign(reason=loads.reason.fillna(""))

    def design_load(self, case: str | None = None, **options: Any) -> pandas.Series:
        """The one to quote of a case, which may be left out where there is one: the first `quantile` by "both tails",
        with its 95 % interval (`load`, `load_low`, `load_high`; of="yaw": `yaw` and so on). `options` as of
        design_loads. Raises Refused where there is none, with the reason."""
        if case is None and len(self._cases) > 1:
            raise CampaignError(f"Which case? {self.path} has {', '.join(self._cases.index)}.")
        name = self._cases.index[0] if case is None else self._checked(case)
        loads = self.design_loads(**options)
        found = loads[(loads.case == name) & (loads.method == "both tails") & (loads.figure == "quantile")]
        if found.empty:
            raise program.Refused(f"{name}: it has no {options.get('of', 'load')}.")
        first = found.iloc[0]
        if first.reason:
            raise program.Refused(f"{name}: {first.reason}")
        return first.drop("reason")

    def design_basis(self, **options: Any) -> pandas.DataFrame:
        """What the design loads rest on: a row for each case, with the time that was run, peaks, trend and tail."""
        return pandas.DataFrame(program.ask("design", self.path, **options)["design"]["basis"])

    def _headlines(self) -> pandas.DataFrame:
        """Means over arrangements with their 95 % intervals, as words: a row for each case."""
        largest = [key for key in ("mean_maximum_1s", "mean_maximum") if key in self._quantities.index][:1]
        summary, lines = self.summary(), {}
        for case in self._cases.index:
            line: dict[str, Any] = {"done": int((self._members.status[self._members.case == case] == "done").sum())}
            for key in ["mean_load", *largest, "failure_ratio"]:
                one = summary.loc[(case, key)]
                percent = key == "failure_ratio"
                values = [value * (100 if percent else 1) for value in (one.estimate, one.low, one.high)]
                unit = "%" if percent else one.units
                words = "–" if numpy.isnan(values[0]) else f"{values[0]:.2f}"
                if not numpy.isnan(values[1]):
                    words += f" [{values[1]:.2f}, {values[2]:.2f}]"
                line[f"{self._quantities.long_name[key]}, {unit}"] = words
            lines[case] = line
        return pandas.DataFrame.from_dict(lines, orient="index").rename_axis("case")

    # -- read once

    @cached_property
    def _cases(self) -> pandas.DataFrame:
        return tables.table(self._stored, "cases").set_index("name").rename_axis("case")

    @cached_property
    def _quantities(self) -> pandas.DataFrame:
        return tables.quantities(self._stored)

    @cached_property
    def _members(self) -> pandas.DataFrame:
        return tables.members(self._stored, self._cases.index.tolist(), self._quantities)

    @cached_property
    def _configuration(self) -> Configuration:
        text = str(self._stored.read("provenance/configuration"))
        with self._stored.reading("/provenance/configuration"):
            return Configuration(text)

    def _checked(self, case: str) -> str:
        if case not in self._cases.index:
            known = ", ".join(self._cases.index)
            raise CampaignError(f"There is no case '{case}' in this campaign; its cases are {known}.")
        return case

    def _listed(self, group: str) -> pandas.DataFrame:
        """A group with any number of rows for a member, and its case."""
        rows = tables.table(self._stored, group)
        if not rows.member.isin(self._members.index).all():
            raise self._stored.damaged(f"/{group}/member names a member that the campaign does not have")
        rows.insert(1, "case", self._members.case.to_numpy()[rows.member])
        return rows

    def _of_members(self, group: str) -> xarray.Dataset | None:
        """A group with a row for each member, and whose they are."""
        if not self._stored.has(group):
            return None
        case = xarray.Variable("member", self._members.case.to_numpy(), {"long_name": "case"})
        return self._stored.group(group).assign_coords(case_name=case)

    def _histories(self, members: list[int], case: str) -> xarray.Dataset:
        about = self._cases.loc[case]
        found = tables.histories(self._stored, members, about.time_step, about.get("history_stride", 1))
        return found.assign_attrs(case=case, steady_start=float(about.steady_start))
