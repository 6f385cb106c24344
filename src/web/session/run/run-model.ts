import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { reachesAll, type InputAction } from '#simulation/input';
import { SPEEDS, type RunPhase, type Speed } from '#simulation/pace';
import type { RunSetup } from '#simulation/run-setup';
import type { Ended } from '#simulation/simulation';

import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';
import { DebugPort } from './debug-port';
import type { EarlierRuns } from './earlier-runs';
import { LookPort } from './look-port';
import { PictureRequests } from './picture-requests';
import { Recording, type Asked, type BroughtTape } from './recording';
import { Trails } from './trails';
import type { FromWorker, Output, RunEvents } from './worker/protocol';
import { RunClient, type ClientOptions, type ToRun } from './run-client';

/** A run is called busy when it has sent nothing for this long, in ms: it is inside one long call. */
const BUSY_AFTER_MS = 1000;

/** Time the VM may take to load before a notice is shown, in ms. Chosen: a slow school network needs less. */
const SLOW_MS = 10_000;

/** Waits for the work; if it takes long, a notice is shown. */
function patiently(work: Promise<void>, tell: () => unknown): Promise<void> {
  const timer = setTimeout(tell, SLOW_MS);
  return work.finally(() => clearTimeout(timer));
}

/** The app around a run. */
export interface RunHost extends Pick<ClientOptions, 'createWorker' | 'firmware'> {
  /** Set-up of a run that starts now. @param kept set-up of a recorded run that is to be repeated */
  setup(kept?: RunSetup): RunSetup;
  /** Place of the device whose board and program are shown. Left out: the first. */
  device?(): number;
  /** True if this action is forbidden; left out: all are allowed. */
  refuses?(action: InputAction): boolean;
  /** Called for each input to a board, whether a run takes it or not. */
  onInput(action: InputAction, device: number): void;
  onStart(): void;
  onOutput(output: Output): void;
  onEnded(ended: Ended, device: number): void;
  /** The program runs again from its start: Ctrl-D at the REPL. */
  onRestarted(device: number): void;
  /** New sounds, radio packets and log rows. */
  onEvents(events: RunEvents, device: number): void;
  /** The VM could not be loaded. @param why see `troubleOf` */
  onUnavailable(why: unknown): void;
  /** The VM takes long to load. */
  onSlow?(): void;
  onFailed(message: string): void;
  /** The run rejected an input and continues without it. */
  onRefused(message: string): void;
  onKilled(): void;
}

/** A room that takes note of runs. */
export type RunListener = Partial<Pick<RunHost, 'onStart' | 'onOutput' | 'onEnded' | 'onRestarted'>>;

/** The options of a start. */
export interface Beginning {
  /** Set-up of an earlier run that is to be repeated; left out: a new one. */
  readonly kept?: RunSetup;
  readonly paused: boolean;
  /** Until this simulated time it runs as fast as it can. */
  readonly catchUpUs?: number;
  /** The run that is left for this one. */
  readonly left?: Recording | null;
  /** The tape of a run recorded earlier: the page looks back at it while the run is repeated. */
  readonly brought?: BroughtTape | null;
  /** The moment that is shown until the run has caught up. */
  readonly shown?: Snapshot | null;
  /** The moment requested in the meantime. */
  readonly asked?: Asked;
}

/**
 * The run as the page sees it. Reading costs nothing; every command is sent to the worker and returns as a change here.
 */
export class RunModel {
  readonly phase: ShallowRef<RunPhase> = shallowRef<RunPhase>('ready');
  /** The newest picture of the run; `null`: there is none. */
  readonly present: ShallowRef<Snapshot | null> = shallowRef(null);
  /** Looking back at the past moments of the run. */
  readonly look = new LookPort(this, () => {
    this.pause();
    this.client.send({ type: 'tape' });
  });
  /** The moment shown instead of the present; `null`: the page shows the present. Only `look` changes it. */
  readonly past = this.look.past;
  /** The visible state: the present of the run, or a past moment. */
  readonly snapshot: ComputedRef<Snapshot | null> = computed(() => this.past.value ?? this.present.value);
  /** The same with the board, program and robot of the device that is shown in the first one's place. */
  readonly shown: ComputedRef<Snapshot | null> = computed(() => {
    const snapshot = this.snapshot.value;
    const device = this.deviceNow(this.device);
    return snapshot === null || device === null || device === snapshot ? snapshot : { ...snapshot, ...device };
  });
  /** The paths that the robots have taken; their contents change with `snapshot`. */
  readonly trails = new Trails();
  /** End of each device's program, by its place; missing before there is a run. */
  readonly endings: ShallowRef<readonly (Ended | null)[]> = shallowRef([]);
  /** End of the program of the device that is shown. */
  readonly ended: ComputedRef<Ended | null> = computed(() => this.endings.value[this.device] ?? null);
  readonly nowUs = computed(() => this.snapshot.value?.timeUs ?? 0);
  /** The recording of the run for looking back. */
  readonly recording: ShallowRef<Recording> = shallowRef(new Recording(null));
  /** The runs before this one; `null`: none was worth recording yet. */
  readonly earlier: ShallowRef<EarlierRuns | null> = shallowRef(null);
  /** Simulated seconds per wall second reached lately; `null` while unknown. */
  readonly achieved: ShallowRef<number | null> = shallowRef(null);
  readonly isBusy = shallowRef(false);
  /**
   * Replaces the start for every Run button, for a host that sends its program first; `null`: the button starts the
   * run.
   */
  readonly ask: ShallowRef<(() => void) | null> = shallowRef(null);
  readonly isActive = computed(() => ['starting', 'running', 'paused', 'stopping'].includes(this.phase.value));
  /** All programs have ended. */
  readonly hasEnded = computed(() => this.endings.value.length > 0 && !this.endings.value.includes(null));
  /** All programs have ended, and the world keeps running. */
  readonly isOver = computed(() => this.isActive.value && this.hasEnded.value);
  /** The program waits in `input()`: only the user can continue it. */
  readonly isWaitingForInput = computed(
    () =>
      (this.phase.value === 'running' || this.phase.value === 'paused') &&
      this.ended.value === null &&
      this.shown.value?.awaitsInput === true,
  );
  /** Breakpoints, steps and the program's variables at a stop. */
  readonly debug = new DebugPort({ phase: this.phase, send: (message) => this.send(message) });
  private speed: Speed = 1;
  private heardMs = 0;
  private readonly client: RunClient;
  private readonly pictures = new PictureRequests({
    isActive: () => this.isActive.value,
    ask: () => this.client.send({ type: 'frame' }),
    onFrame: () => {
      this.isBusy.value = this.phase.value === 'running' && performance.now() - this.heardMs > BUSY_AFTER_MS;
    },
  });

  constructor(private readonly host: RunHost) {
    this.client = new RunClient({
      createWorker: () => host.createWorker(),
      firmware: () => host.firmware(),
      onMessage: (message) => this.hear(message),
      onKilled: () => {
        this.end('killed');
        host.onKilled();
      },
    });
  }

  /** Makes workers, and the VM for them: for other parts that run something. */
  get engine(): Pick<RunHost, 'createWorker' | 'firmware'> {
    return this.host;
  }

  /** Makes the next run immediate. A failure is not reported here: the run will report it. */
  warmUp(): void {
    this.client.warmUp().catch(() => undefined);
  }

  /** For every Run button: runs the program, or asks the host to send the program first. */
  press(): void {
    if (this.ask.value === null) void this.start();
    else this.ask.value();
  }

  /** Starts a new run, also during a run; with `paused` it starts paused. */
  start(paused = false): Promise<void> {
    return this.begin({ paused });
  }

  /** Starts a new run in any of the possible ways. */
  async begin({ kept, paused, catchUpUs = 0, left = null, brought = null, ...look }: Beginning): Promise<void> {
    this.starts += 1;
    const { starts } = this;
    const { value: before } = this.recording;
    this.client.expect((message) => before.hear(message));
    this.debug.begin();
    this.phase.value = 'starting';
    this.clear();
    this.achieved.value = null;
    this.pictures.reset();
    this.startsPaused = paused;
    this.catchUpUs = catchUpUs;
    this.host.onStart();
    const isWanted = (): boolean => starts === this.starts && this.phase.value === 'starting';
    if (!isWanted()) return; // a listener of the start has stopped it
    try {
      const setup = this.host.setup(kept);
      this.recording.value = new Recording(setup, left, brought);
      this.look.begin(look.shown, look.asked);
      this.names = setup.devices.map(({ name }) => name);
      this.endings.value = this.names.map(() => null);
      await patiently(this.client.start(setup, { speed: this.speed, paused, catchUpUs }), () => isWanted() && this.host.onSlow?.()); // prettier-ignore
    } catch (why) {
      if (!isWanted()) return;
      this.end('failed');
      this.host.onUnavailable(why);
    }
  }
  private startsPaused = false;
  private catchUpUs = 0;
  /** Counts starts, so that a stop or reset that had to wait notices that another run has begun. */
  private starts = 0;

  /**
   * Ends the run, even one that is still starting; the last picture stays. Every call resolves when the run is over.
   */
  stop(): Promise<void> {
    if (this.isActive.value && this.phase.value !== 'stopping') {
      this.phase.value = 'stopping';
      this.stopping = this.endRun(this.starts);
    }
    return this.stopping;
  }
  private stopping: Promise<void> = Promise.resolve();

  private async endRun(starts: number): Promise<void> {
    const result = await this.client.stop();
    if (result === 'stopped' && starts === this.starts && this.isActive.value) this.end('stopped');
  }

  /** Ends the run and puts everything back to the start. */
  async reset(): Promise<void> {
    const { starts } = this;
    await this.stop();
    if (starts !== this.starts) return;
    this.phase.value = 'ready';
    this.clear();
  }

  private clear(): void {
    this.trails.clear();
    this.present.value = null;
    this.look.begin();
    this.recording.value = new Recording(null);
    this.endings.value = [];
  }

  pause(): void {
    if (this.phase.value !== 'running') return;
    this.send({ type: 'pause' });
    this.phase.value = 'paused';
    this.achieved.value = null;
  }

  resume(): void {
    if (this.phase.value !== 'paused') return;
    this.send({ type: 'resume' });
    this.phase.value = 'running';
  }

  /** Lets one step of simulated time pass and leaves the run paused; without a run it starts one. */
  step(): void {
    if (!this.isActive.value) {
      void this.start(true);
      this.send({ type: 'step' });
      return;
    }
    if (this.phase.value === 'stopping') return;
    this.send({ type: 'step' });
    this.startsPaused = true;
    if (this.phase.value !== 'starting') this.phase.value = 'paused';
    this.achieved.value = null;
  }

  setSpeed(speed: Speed): void {
    this.speed = SPEEDS.includes(speed) ? speed : 1;
    this.achieved.value = null;
    this.send({ type: 'speed', speed: this.speed });
  }

  /**
   * Sends an input to the run; if the run is still starting, at its first moment. Without a run only the host hears of
   * it.
   *
   * @param device its place; left out: the one that is shown, or all that it reaches
   * @returns whether the action is allowed at all
   */
  input(action: InputAction, device?: number): boolean {
    if (this.host.refuses?.(action) === true) return false;
    this.look.leave(); // inputs affect the present
    this.host.onInput(action, device ?? this.device);
    const place = device ?? (reachesAll(action) ? null : this.device);
    const name = place === null || (place === 0 && !reachesAll(action)) ? undefined : this.names[place];
    const message = { type: 'input', action, ...(name !== undefined && { device: name }) } as const;
    if (this.isActive.value && !this.send(message)) this.host.onRefused('Too much is done before the program begins.');
    return true;
  }

  /** A device in the picture that is shown, or `null`. */
  deviceNow(device: number): DeviceSnapshot | null {
    const snapshot = this.snapshot.value;
    return device === 0 ? snapshot : (snapshot?.others[device - 1] ?? null);
  }

  /** Place of the device that is shown. */
  get device(): number {
    return this.host.device?.() ?? 0;
  }
  /** Names of the run's devices, by their place. */
  private names: readonly string[] = [];

  private hear(message: FromWorker): void {
    this.heardMs = performance.now();
    this.isBusy.value = false;
    if (message.type !== 'prepared') this.pictures.rest(message.type === 'resting');
    switch (message.type) {
      case 'prepared':
        break;
      case 'started':
        if (this.phase.value === 'starting') this.phase.value = this.startsPaused ? 'paused' : 'running';
        this.pictures.begin();
        this.warmUp();
        break;
      case 'snapshot':
        this.pictures.came();
        this.trails.add(message.trails, message.snapshot.timeUs);
        this.present.value = message.snapshot;
        this.endCatchingUp(message.snapshot.timeUs);
        break;
      case 'tape':
      case 'inputs':
        this.recording.value.hear(message);
        break;
      case 'alive':
      case 'resting':
        this.achieved.value = message.type === 'alive' && this.phase.value === 'running' ? message.achieved : null;
        break;
      case 'held':
      case 'variables':
        this.debug.hear(message);
        break;
      case 'console':
        message.output.forEach((output) => this.host.onOutput(output));
        this.client.send({ type: 'console-taken' });
        break;
      case 'program-ended':
        this.setEnded(message.device, message.ended);
        this.host.onEnded(message.ended, message.device);
        break;
      case 'program-restarted':
        this.setEnded(message.device, null);
        this.host.onRestarted(message.device);
        break;
      case 'events':
        this.host.onEvents(this.catchUpUs > 0 ? { ...message.events, sound: [] } : message.events, message.device);
        break;
      case 'stopped':
        this.end('stopped');
        break;
      case 'refused':
        this.host.onRefused(message.message);
        break;
      case 'failed':
        this.end('failed');
        this.host.onFailed(message.message);
        break;
      default:
        message satisfies never;
    }
  }

  /**
   * Ends catching up once the run has reached its moment: now it is heard, and shown unless it was recorded earlier.
   */
  private endCatchingUp(nowUs: number): void {
    if (this.catchUpUs === 0 || nowUs < this.catchUpUs) return;
    this.catchUpUs = 0;
    if (!this.recording.value.isBrought) this.look.leave();
    else if (this.past.value !== null) this.look.back(); // the rest of its moments
  }

  private setEnded(device: number, ended: Ended | null): void {
    this.endings.value = this.endings.value.map((before, place) => (place === device ? ended : before));
  }

  /** Sends a message to the run, which may wake it. @returns whether it was sent */
  private send(message: ToRun): boolean {
    this.pictures.rest(false);
    return this.client.send(message);
  }

  private end(phase: 'stopped' | 'killed' | 'failed'): void {
    this.pictures.end();
    this.phase.value = phase;
    this.achieved.value = null;
    this.isBusy.value = false;
    this.warmUp();
  }
}
