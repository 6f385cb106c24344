import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';

import { isSame } from '#core/same';
import { filesOfDevice } from '#project/devices';
import type { Shown } from '#vm/debug/shown';
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';
import { whenIdle } from '../../kit/when-idle';
import type { PointsOfDevices } from '../../session/run/debug-port';
import { BreakPoints } from './break-points';
import { changesBetween, type Before } from './changes';
import { fileKey } from './file-key';
import { Past, type PastParts } from './past';
import { changedFile, stepAsRan } from './ran-program';

/** The state in which the program of the shown device can be looked into. */
export interface Stillness {
  /** True while the run is paused and the program has not ended, and no past moment is shown. */
  readonly isStanding: ComputedRef<boolean>;
  /** True while it is halted, or while a past moment is shown. */
  readonly isInspectable: ComputedRef<boolean>;
  /** True if the variables are shown in the board's place. */
  readonly showsVariables: ShallowRef<boolean>;
}

/** A place in a program. */
export interface Place {
  readonly file: string;
  readonly line: number;
}

/** A place in a program that may have been written on since. */
export interface Here {
  readonly file: string;
  /** `null`: the line has been removed since. */
  readonly line: number | null;
  /** The text of the line when it ran, if the file is another one by now; else `null`. */
  readonly ran: string | null;
}

/** The state found at a stop. */
interface Found {
  readonly device: number;
  readonly variables: Variables;
  /** The former value of each variable that has changed since the last stop. */
  readonly before: Before;
}

/** Rest of the time line before variables are requested, in ms. Chosen: a drag requests none. */
const SETTLED_MS = 150;

/** Break points, stepping by lines, and variables of programs. */
export class Debug {
  readonly points = new BreakPoints(tabStore());
  /** Place of the shown device's program, in a moment of the past, too; `null`: it runs, or has ended. */
  readonly place: ComputedRef<Place | null>;
  /** The same in the program as it is written now. */
  readonly here: ComputedRef<Here | null>;
  /** The state of the shown device while its program is halted or looked back on. */
  readonly found: ShallowRef<Found | null> = shallowRef(null);
  private readonly last = new Map<number, Variables>();
  private toldPoints: PointsOfDevices = [];

  /** The run repeated, for moments of the past. */
  readonly past: Past;

  constructor(
    private readonly app: PastParts,
    private readonly slot: Stillness,
  ) {
    const { run, work } = app;
    const { isStanding, isInspectable, showsVariables } = slot;
    this.past = new Past(app, (device, variables) => this.find(device, variables));
    this.place = computed(() => {
      const position = isInspectable.value ? (run.shown.value?.position ?? null) : null;
      return position === null ? null : { file: position.file, line: position.line };
    });
    this.here = computed(() => {
      if (this.place.value === null) return null;
      const { file, line } = this.place.value;
      const changed = changedFile(app, work.place.value, file);
      if (changed === null) return { file, line, ran: null };
      return { file, line: changed.now(line), ran: changed.text.split(/\r?\n/)[line - 1]?.trim() ?? '' };
    });
    const written = () => work.work.value.project;
    watch([this.points.lines, written, work.devices, run.recording], () => this.tellPoints(), {
      immediate: true,
    });
    watch(work.openings, () => this.points.clear());
    watch(run.recording, () => this.last.clear());
    const moment = computed(() => (isStanding.value ? `${work.place.value} ${run.nowUs.value}` : null));
    watch(moment, (now) => now !== null && this.look(), { immediate: true });
    watch(isInspectable, (still) => still || this.forget());
    let shownIn: unknown = null;
    watch(run.debug.held, (held) => {
      if (held !== null) work.showDevice(held.device); // who waits for another device's line would see nothing of it
      if (isStanding.value) this.look();
      if (held === null || shownIn === run.recording.value) return;
      shownIn = run.recording.value; // once a run: who goes back to the board stays there
      showsVariables.value = true;
    });
    watch(run.debug.told, (told) => {
      if (told !== null && isStanding.value && told.device === work.place.value) this.find(told.device, told.variables);
    });
    this.followPast(showsVariables);
  }

  /** Requests variables of the past, which cost a run, only while they are shown and the time line rests. */
  private followPast(showsVariables: Readonly<Ref<boolean>>): void {
    const { run, work } = this.app;
    const isPast = (): boolean => run.past.value !== null;
    watch(isPast, (now) => now && whenIdle(() => void this.past.prepare()), { immediate: true });
    let timer: ReturnType<typeof setTimeout> | undefined;
    watch(
      [run.past, work.place, showsVariables],
      ([past, , isSeen]) => {
        clearTimeout(timer);
        if (past !== null && isSeen) timer = setTimeout(() => void this.past.look(), SETTLED_MS);
      },
      { immediate: true },
    );
  }

  /** Steps on line by line: the program of the shown device makes a step, or goes on up to a line. */
  step(step: LineStep): void {
    const asRan = stepAsRan(this.app, this.app.work.place.value, step);
    if (asRan === null) return;
    if (this.slot.isStanding.value) this.app.run.debug.step(asRan, this.app.work.place.value);
    else void this.stepInPast(asRan);
  }

  /**
   * Steps in the past. If no recorded line follows, it returns to the present. It makes the step there if that was the
   * present moment already, or if the program is still in the midst of the same line: else nothing would move.
   */
  private async stepInPast(step: LineStep): Promise<void> {
    const { run, work } = this.app;
    const turn = ++this.turns;
    const isNow = run.look.isAtPresent.value;
    if (!isNow && (await this.past.step(step))) return;
    if (turn !== this.turns || run.past.value === null) return; // somebody wants something else by now
    const before = this.place.value;
    run.look.leave();
    const isThere = isNow || isSamePlace(before, this.place.value);
    if (isThere && this.slot.isStanding.value) run.debug.step(step, work.place.value);
  }

  /** Lets the program go on, from a past moment after the return to the present. */
  goOn(): void {
    this.turns += 1;
    this.app.run.look.leave();
    if (this.slot.isStanding.value) this.app.run.resume();
  }

  /** Counts the requests for moments of the past. */
  private turns = 0;

  /** Goes to the line that began before, in the past. */
  back(): void {
    this.turns += 1;
    void this.past.back();
  }

  /** Goes to the line that has raised the error by which the program ended, with its variables as they were. */
  toError(timeUs: number, line: number | null): void {
    this.slot.showsVariables.value = true;
    void this.past.toError(timeUs, line);
  }

  /** The value of a name where the program is halted: of the innermost call, else of the file. */
  valueOf(name: string): Shown | null {
    const variables = this.found.value?.variables;
    const known = [...(variables?.stack[0]?.locals ?? []), ...(variables?.globals ?? [])];
    return known.find((one) => one.name === name)?.value ?? null;
  }

  private find(device: number, variables: Variables): void {
    const last = this.last.get(device) ?? null;
    if (last !== null && this.found.value?.device === device && isSame(last, variables)) return;
    this.found.value = { device, variables, before: changesBetween(last, variables) };
    this.last.set(device, variables);
  }

  private look(): void {
    this.app.run.debug.inspect(this.app.work.place.value);
  }

  private forget(): void {
    this.found.value = null;
  }

  /** The break points of a file, in the lines of the program that the run began with. */
  private linesOf(place: number, file: string, lines: readonly number[]): BreakPoint[] {
    const changed = this.app.run.isActive.value ? changedFile(this.app, place, file) : null;
    return lines.flatMap((now) => {
      const line = changed === null ? now : changed.before(now);
      return line === null ? [] : [{ file, line }];
    });
  }

  private tellPoints(): void {
    const { run, work } = this.app;
    const { project } = work.work.value;
    const points = work.devices.value.map((_, place) =>
      filesOfDevice(project, place).flatMap(({ name }): BreakPoint[] =>
        this.linesOf(place, name, this.points.of(fileKey(project, place, name))),
      ),
    );
    if (isSame(points, this.toldPoints)) return; // the program changes with every key
    this.toldPoints = points;
    run.debug.setBreakPoints(points);
  }
}

const isSamePlace = (one: Place | null, other: Place | null): boolean =>
  one?.file === other?.file && one?.line === other?.line;

function tabStore(): Storage | null {
  try {
    return sessionStorage;
  } catch {
    return null;
  }
}
