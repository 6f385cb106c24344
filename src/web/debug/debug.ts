import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import { isSame } from '#core/same';
import { filesOfDevice } from '#project/devices';
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';
import type { PointsOfDevices } from '../run/debug-port';
import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';
import { BreakPoints } from './break-points';
import { changesBetween, type Before } from './changes';
import { fileKey } from './file-key';

/** A place in a program. */
export interface Place {
  readonly file: string;
  readonly line: number;
}

/** What a program was found with. */
interface Found {
  readonly device: number;
  readonly variables: Variables;
  /** What each variable that has changed since the stop before was then. */
  readonly before: Before;
}

/** Where programs stop, how they go on line by line, and what their variables are. */
export class Debug {
  readonly points = new BreakPoints(tabStore());
  /** Where the device that is shown stands, in a moment of the past, too; `null`: its program runs, or is over. */
  readonly place: ComputedRef<Place | null>;
  /** Of the device that is shown, while its program stands. */
  readonly found: ShallowRef<Found | null> = shallowRef(null);
  private readonly last = new Map<number, Variables>();
  private toldPoints: PointsOfDevices = [];

  constructor(
    private readonly app: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>,
    isStanding: ComputedRef<boolean>,
  ) {
    const { run, work } = app;
    this.place = computed(() => {
      const isStill = isStanding.value || run.past.value !== null;
      const position = isStill ? (run.shown.value?.position ?? null) : null;
      return position === null ? null : { file: position.file, line: position.line };
    });
    watch([this.points.lines, () => work.work.value.project, work.devices], () => this.tellPoints(), {
      immediate: true,
    });
    watch(work.openings, () => this.points.clear());
    watch(run.recording, () => this.last.clear());
    const moment = computed(() => (isStanding.value ? `${work.place.value} ${run.nowUs.value}` : null));
    watch(moment, (now) => (now === null ? this.forget() : this.look()), { immediate: true });
    watch(run.debug.held, () => isStanding.value && this.look());
    watch(run.debug.told, (told) => {
      if (told === null || !isStanding.value || told.device !== work.place.value) return;
      const { device, variables } = told;
      const last = this.last.get(device) ?? null;
      if (last !== null && this.found.value?.device === device && isSame(last, variables)) return;
      this.found.value = { device, variables, before: changesBetween(last, variables) };
      this.last.set(device, variables);
    });
  }

  /** Goes on line by line: the program that is shown makes a step, or goes on up to a line. */
  step(step: LineStep): void {
    this.app.run.debug.step(step, this.app.work.place.value);
  }

  private look(): void {
    this.app.run.debug.inspect(this.app.work.place.value);
  }

  private forget(): void {
    this.found.value = null;
  }

  private tellPoints(): void {
    const { run, work } = this.app;
    const { project } = work.work.value;
    const points = work.devices.value.map((_, place) =>
      filesOfDevice(project, place).flatMap(({ name }): BreakPoint[] =>
        this.points.of(fileKey(project, place, name)).map((line) => ({ file: name, line })),
      ),
    );
    if (isSame(points, this.toldPoints)) return; // the program changes with every key
    this.toldPoints = points;
    run.debug.stopAt(points);
  }
}

function tabStore(): Storage | null {
  try {
    return sessionStorage;
  } catch {
    return null;
  }
}
