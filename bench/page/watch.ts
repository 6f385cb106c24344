import type { OnItsWay } from '../../src/web/session/run/worker/pictures';

declare global {
  interface Window {
    /** In the measured page: what `watchPage` has seen. */
    bench: Watch;
  }
}

/** Data recorded inside the page during a measurement. All times are in ms since the page was requested. */
export interface Watch {
  /** The first frame with an editor that takes text has been drawn. */
  usableMs: number | null;
  /** The first frame with the robot elsewhere than at its start has been drawn. */
  movingMs: number | null;
  /** Runs that have started. */
  started: number;
  /** Pictures that the worker sent in this run. */
  snapshots: number;
  /** Simulated time of the newest of them, in µs. */
  timeUs: number;
  /** Start of each animation frame; the measuring code empties the list. */
  frames: number[];
  /** All files are kept for visits without a network; written by `untilKept`. */
  isKept: boolean;
}

type Keyed = Record<string, unknown>;

/** The things on the page that a measurement touches, as CSS selectors. */
export const PLACES = {
  run: 'button.run',
  stop: 'button.stop',
  editor: '.code-editor .cm-content[contenteditable=true]',
  speed: '.ctl.speed',
  choice: '.menu-card .page-list-item',
  arena: '[data-testid=arena]',
  build: '[data-testid=mode-build]',
  lookBack: '[data-testid=mode-lookBack]',
  pen: '[data-tool=pen]',
  select: '[data-tool=select]',
  bin: '[data-testid=remove]',
} as const;

/** Further than this from the start, in mm, the robot counts as moving. */
const MOVED_MM = 1;

/** Options of `watchPage`. */
export interface WatchOptions {
  readonly places: typeof PLACES;
  readonly movedMm: number;
  /** Presses Run as soon as the editor is usable. */
  readonly pressRun: boolean;
}

/** The options of a page that is opened to be looked at, or to be run at once. */
export const watchOptions = (pressRun: boolean): WatchOptions => ({ places: PLACES, movedMm: MOVED_MM, pressRun });

/** Runs in the page before its own code: listens to the frames and to what the workers say, and changes nothing. */
export function watchPage({ places, movedMm, pressRun }: WatchOptions): void {
  const watch: Watch = {
    usableMs: null,
    movingMs: null,
    started: 0,
    snapshots: 0,
    timeUs: 0,
    frames: [],
    isKept: false,
  };
  window.bench = watch;
  let start: { readonly xMm: number; readonly yMm: number } | null = null;

  const afterFrame = (note: () => void): void => {
    requestAnimationFrame(() => setTimeout(note));
  };
  const onFrame = (frameMs: number): void => {
    watch.frames.push(frameMs);
    if (watch.usableMs === null && document.querySelector(places.editor) !== null) {
      watch.usableMs = frameMs;
      afterFrame(() => {
        watch.usableMs = performance.now();
        if (pressRun) document.querySelector<HTMLElement>(places.run)?.click();
      });
    }
    requestAnimationFrame(onFrame);
  };
  requestAnimationFrame(onFrame);

  const below = (changes: unknown, key: string): unknown =>
    Array.isArray(changes) ? [(changes[0] as Keyed | null)?.[key]] : (changes as Keyed | undefined)?.[key];
  const newestAt = (changes: unknown, path: string, old: number): number => {
    const found = path.split('.').reduce(below, changes);
    return Array.isArray(found) && typeof found[0] === 'number' ? found[0] : old;
  };
  const pose = { xMm: 0, yMm: 0 };
  const hear = (message: OnItsWay): void => {
    if (message.type === 'started') {
      watch.started += 1;
      watch.snapshots = watch.timeUs = 0;
      start = null;
    }
    if (message.type !== 'picture') return;
    watch.snapshots += 1;
    watch.timeUs = newestAt(message.changes, 'timeUs', watch.timeUs);
    for (const axis of ['xMm', 'yMm'] as const)
      pose[axis] = newestAt(message.changes, `robot.pose.${axis}`, pose[axis]);
    if (watch.movingMs !== null) return;
    start ??= { ...pose };
    if (Math.abs(pose.xMm - start.xMm) + Math.abs(pose.yMm - start.yMm) < movedMm) return;
    watch.movingMs = performance.now();
    afterFrame(() => (watch.movingMs = performance.now()));
  };
  window.Worker = class extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      this.addEventListener('message', (event: MessageEvent<OnItsWay>) => hear(event.data));
    }
  };
}
