import { computed, shallowRef, type ShallowRef } from 'vue';

import { shownNames } from '#check/report/names';
import type { Unread } from '#check/hand-in/unread';
import { Asker, inLanes, START_MS, type Every, type Start } from '#check/lane';
import type { Choice } from '#intake/contents';
import { contentOf, withOwnNames, type Source } from '#intake/sources';
import { comparison, differences, drawOf, tournamentFile, type Entry, type ToldTournament } from '#lab/tournament/file';
import { inRounds } from '#lab/tournament/league';
import { isForOne, MATCH_END, type Files } from '#lab/tournament/match-setup';
import { resultOfRun, type Match, type MatchResult, type Pairing } from '#lab/tournament/match';
import { matchCount, type Draw, type Mode } from '#lab/tournament/play';
import { stageSetup } from '#lab/tournament/stage-setup';
import { playedStages, type Stage, type StagePlan } from '#lab/tournament/stages';
import { stuckOutcome } from '#lab/outcome';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import { filesByName } from '#project/project';
import type { Scene } from '#scene/scene';
import type { RunSetup } from '#simulation/run-setup';

import { troubleKey, type TroubleKey } from '../../../session/run/worker/firmware-trouble';

/** The course of a tournament. */
export interface Course {
  readonly name: string;
  /** Its name in a list, if that is another one. */
  readonly label?: string;
  /** Its source: `OPEN` (`use-tournament.ts`), `file`, or the id of a ready course. */
  readonly from: string;
  readonly scene: Scene;
}

/** A program that was handed in. */
export interface Program {
  /** Unlike the others. */
  readonly name: string;
  /** The name as people read it; unlike the others, too. */
  readonly shown: string;
  /** `null`: not read yet, or not readable. */
  readonly files: Files | null;
  /** Why it cannot play; `null`: it can, or is not read yet. */
  readonly problem: Unread | null;
  /** The files of which one is the program; left out: it is known which. */
  readonly choices?: readonly Choice[];
}

/** A stage while it is played: `matches` are those that have ended, in the order of the stage. */
export interface LiveStage extends StagePlan {
  readonly matches: readonly Match[];
  /** The same in the order in which they have ended. */
  readonly ended: readonly Match[];
  /** Number of matches when it is over. */
  readonly of: number;
}

/** `enter`: course and programs are being chosen. */
export type Phase = 'enter' | 'playing' | 'stopped' | 'over';

/** The services that a tournament needs. */
export interface TournamentPorts {
  /** Gives a function that starts threads that make runs. Rejects without the VM. */
  starter(): Promise<Start<RunRequest, RunAnswer>>;
  readonly every: Every;
  readonly lanes: number;
}

/** Seeds of a tournament of so many turns: in each, each pair plays on both sides. */
const seedsOf = (turns: number): readonly number[] => Array.from({ length: turns }, (_, place) => place + 1);

/** A tournament: its course, its programs, and its matches, which stay while the page is open. */
export class TournamentModel {
  readonly course: ShallowRef<Course | null> = shallowRef(null);
  readonly programs: ShallowRef<readonly Program[]> = shallowRef([]);
  readonly mode = shallowRef<Mode>('league');
  readonly seeds: ShallowRef<readonly number[]> = shallowRef(seedsOf(1));
  readonly phase = shallowRef<Phase>('enter');
  readonly stages: ShallowRef<readonly LiveStage[]> = shallowRef([]);
  /** The reason why nothing can be played, as a key or in words; `null`: none. */
  readonly failure: ShallowRef<TroubleKey | { readonly problem: string } | null> = shallowRef(null);
  /** Number of tournaments that there were here: another one has other matches under the same names. */
  readonly count = shallowRef(0);
  /** The results that its file tells; `null`: it is from no file. */
  readonly told: ShallowRef<ToldTournament['told'] | null> = shallowRef(null);
  /** Number of matches that have come out otherwise than the file says; `null`: from no file, or not over yet. */
  readonly differing = computed(() =>
    this.told.value === null || this.phase.value !== 'over'
      ? null
      : differences(comparison(this.whole, this.told.value)),
  );
  /** The programs that can play, and how; `null`: there is no course. */
  readonly entry = computed((): Entry | null => {
    const course = this.course.value;
    if (course === null) return null;
    const programs = this.programs.value.flatMap(({ shown, files }) =>
      files === null ? [] : [{ name: shown, files }],
    );
    // In a course for one nobody meets: there are no brackets.
    const mode = isForOne(course.scene) ? 'league' : this.mode.value;
    return { name: course.name, scene: course.scene, programs, mode, seeds: this.seeds.value };
  });
  readonly draw = computed((): Draw | null => this.entry.value && drawOf(this.entry.value));
  /** True if there is a result that was not saved. One that is played again is in its file. */
  readonly isUnsaved = computed(
    () =>
      this.told.value === null &&
      this.stages.value.some(({ ended }) => ended.length > 0) &&
      this.stages.value !== this.saved.value,
  );
  /** True if there are programs that were chosen here and are in no file of a tournament. */
  readonly hasUnsavedPrograms = computed(
    () =>
      this.programs.value.length > 0 && this.phase.value !== 'over' && this.programs.value !== this.savedPrograms.value,
  );
  private readonly saved: ShallowRef<readonly LiveStage[]> = shallowRef([]);
  private readonly savedPrograms: ShallowRef<readonly Program[]> = shallowRef([]);
  /** The entry that is being played, from its start until it is set up anew; `null`: none. */
  private playing: Entry | null = null;
  /** The programs of that entry, with those that cannot play. */
  private playingPrograms: readonly Program[] = [];
  private whole: readonly Stage[] = [];
  private sources = new Map<string, Source>();
  private readonly known = new Map<string, MatchResult>();
  private turn = 0;
  private lanes: readonly Asker<RunRequest, RunAnswer>[] = [];

  constructor(private readonly ports: TournamentPorts) {}

  /** Adds programs, and reads them. */
  async add(sources: readonly Source[]): Promise<void> {
    const names = this.programs.value.map(({ name }) => name);
    const named = withOwnNames(sources, names);
    for (const source of named) this.sources.set(source.name, source);
    const added = named.map(({ name }) => ({ name, shown: name, files: null, problem: null }));
    this.programs.value = withShown([...this.programs.value, ...added]);
    for (const source of named) {
      const content = await contentOf(source);
      if (this.sources.get(source.name) !== source) continue;
      this.change(source.name, (before) =>
        'handIn' in content
          ? { ...before, files: filesByName(content.handIn.project.files) }
          : { ...before, problem: content.problem, ...(content.choices && { choices: content.choices }) },
      );
    }
  }

  /** Takes one of several files as a program. */
  take(name: string, { handIn }: Choice): void {
    const files = filesByName(handIn.project.files);
    this.change(name, ({ choices: _, ...before }) => ({ ...before, files, problem: null }));
  }

  /** Removes a program. */
  remove(name: string): void {
    this.sources.delete(name);
    this.programs.value = withShown(this.programs.value.filter((one) => one.name !== name));
  }

  /** Sets the number of turns, in each of which each pair plays on both sides. */
  setTurns(turns: number): void {
    this.seeds.value = seedsOf(turns);
  }

  /** Opens the tournament of a file, and plays it again. */
  open(tournament: ToldTournament): Promise<void> {
    this.enter();
    const { name, scene, programs, mode, seeds, told } = tournament;
    this.course.value = { name, from: 'file', scene };
    this.sources.clear();
    this.programs.value = programs.map((one) => ({ name: one.name, shown: one.name, files: one.files, problem: null }));
    this.savedPrograms.value = this.programs.value;
    this.mode.value = mode;
    this.seeds.value = seeds;
    this.told.value = told;
    return this.start();
  }

  /** Back to the choice of course and programs: what was played is dropped. */
  enter(): void {
    this.stop();
    this.known.clear();
    this.playing = null;
    this.count.value += 1;
    [this.told.value, this.stages.value, this.phase.value] = [null, [], 'enter'];
  }

  /** Plays the matches that have no result yet. */
  async start(): Promise<void> {
    this.stop();
    const { turn } = this;
    if (this.playing === null) this.playingPrograms = this.programs.value;
    const entry = (this.playing ??= this.entry.value);
    if (entry === null) return;
    this.phase.value = 'playing';
    this.failure.value = null;
    this.stages.value = [];
    try {
      const start = await this.ports.starter();
      if (turn !== this.turn) return;
      const found = await playedStages(drawOf(entry), (plan, place, pairings) =>
        this.playAll({ entry, plan, place, turn, start }, pairings),
      );
      if (turn !== this.turn) return;
      this.whole = found ?? [];
      this.phase.value = found === null ? 'stopped' : 'over';
    } catch (error) {
      if (turn !== this.turn) return;
      this.failure.value = troubleKey(error);
      this.phase.value = 'stopped';
    }
  }

  /** Ends the matches in progress; the others keep their results. */
  stop(): void {
    this.turn += 1;
    for (const lane of this.lanes) lane.stop();
    this.lanes = [];
    if (this.phase.value === 'playing') this.phase.value = 'stopped';
  }

  /** The file of the tournament, when it is over. */
  file(): string | null {
    const { playing: entry } = this;
    return entry === null || this.phase.value !== 'over' ? null : tournamentFile(entry, this.whole);
  }

  /** Marks the present result as saved, and the programs with which it was played. */
  noteSaved(): void {
    this.saved.value = this.stages.value;
    this.savedPrograms.value = this.playingPrograms;
  }

  /** The run of a match of a stage; `null`: there is none. */
  setupOf(stage: StagePlan, pairing: Pairing): RunSetup | null {
    const { playing: entry } = this;
    const setup = entry && stageSetup(entry, stage, pairing);
    return setup === null || 'problem' in setup ? null : setup;
  }

  private change(name: string, changed: (before: Program) => Program): void {
    this.programs.value = this.programs.value.map((one) => (one.name === name ? changed(one) : one));
  }

  private async playAll(now: Playing, pairings: readonly Pairing[]): Promise<readonly MatchResult[] | null> {
    const { plan, place, entry } = now;
    const results: (MatchResult | undefined)[] = pairings.map((pairing) => this.known.get(keyOf(plan, pairing)));
    const before = this.stages.value[place];
    const show = this.showing(now, before ?? { ...plan, matches: [], ended: [], of: matchCount(plan) }, pairings);
    show(results, this.inEndingOrder(plan, matchesOf(pairings, results)));
    const waiting = pairings.flatMap((pairing, at) => (results[at] === undefined ? [{ ...pairing, at }] : []));
    const ordered = plan.mode === 'league' ? inRounds(waiting, plan.names.length) : waiting;
    const count = Math.min(this.ports.lanes, ordered.length);
    this.lanes = Array.from({ length: count }, () => new Asker(now.start, this.ports.every, Infinity, START_MS));
    await inLanes(ordered, this.lanes, async ({ at, ...pairing }, _, lane) => {
      if (now.turn !== this.turn) return;
      const setup = stageSetup(entry, plan, pairing);
      const result = 'problem' in setup ? setup : await resultIn(setup, plan, lane);
      if (now.turn !== this.turn) return;
      if ('problem' in result) {
        this.stop();
        this.failure.value = result.problem === UNLOADED ? troubleKey(null) : result;
        return;
      }
      this.known.set(keyOf(plan, pairing), result);
      results[at] = result;
      show(results, [{ ...pairing, ...result }]);
    });
    if (now.turn !== this.turn) return null;
    return results.flatMap((result) => (result === undefined ? [] : [result]));
  }

  /** Matches that were played before a stop, in the order in which they ended: their numbers stay. */
  private inEndingOrder(plan: StagePlan, matches: readonly Match[]): readonly Match[] {
    const places = new Map([...this.known.keys()].map((key, place) => [key, place]));
    const place = (match: Match): number => places.get(keyOf(plan, match)) ?? 0;
    return matches.toSorted((one, other) => place(one) - place(other));
  }

  /** A function that shows the matches of a round that have ended, after those of the rounds before. */
  private showing(
    { place, turn }: Playing,
    before: LiveStage,
    pairings: readonly Pairing[],
  ): (results: readonly (MatchResult | undefined)[], ended: readonly Match[]) => void {
    let all = before.ended;
    return (results, ended) => {
      if (turn !== this.turn) return;
      all = [...all, ...ended];
      const stage = { ...before, matches: [...before.matches, ...matchesOf(pairings, results)], ended: all };
      this.stages.value = [...this.stages.value.slice(0, place), stage];
    };
  }
}

/** The problem of a thread whose code did not come. */
const UNLOADED = '';

/** A stage that is being played. */
interface Playing {
  readonly entry: Entry;
  readonly plan: StagePlan;
  readonly place: number;
  readonly turn: number;
  readonly start: Start<RunRequest, RunAnswer>;
}

/** Names the run of a match, in whatever stage. */
const keyOf = ({ entrants }: StagePlan, { a, b, seed }: Pairing): string =>
  [entrants[a], b === null ? '' : entrants[b], seed].join();

const matchesOf = (pairings: readonly Pairing[], results: readonly (MatchResult | undefined)[]): readonly Match[] =>
  pairings.flatMap((pairing, at) => {
    const result = results[at];
    return result === undefined ? [] : [{ ...pairing, ...result }];
  });

async function resultIn(
  setup: RunSetup,
  { isAlone }: StagePlan,
  lane: Asker<RunRequest, RunAnswer>,
): Promise<MatchResult | { readonly problem: string }> {
  const answer = await lane.ask({ setup, end: MATCH_END });
  if ('reason' in answer) {
    const { code, params } = answer.reason;
    if (code === 'unloaded') return { problem: UNLOADED };
    if (code === 'broken') return { problem: String(params['problem']) };
    return resultOfRun({ outcome: stuckOutcome(true), verdict: null }, isAlone);
  }
  const { result } = answer;
  return 'refused' in result ? { problem: result.refused } : resultOfRun(result, isAlone);
}

function withShown(programs: readonly Program[]): readonly Program[] {
  const shown = shownNames(programs.map(({ name }) => name));
  return programs.map((program, place) => ({ ...program, shown: shown[place] ?? program.name }));
}
