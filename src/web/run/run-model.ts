import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { InputAction } from '#simulation/input';
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

/** A run is called busy when it has said nothing for this long, in ms: it is inside one long call. */
const BUSY_AFTER_MS = 1000;

/** So long the VM may take before that is told, in ms. Chosen: a slow school network needs less. */
const SLOW_MS = 10_000;

/** The same work; where it takes long, that is told. */
function patiently(work: Promise<void>, tell: () => unknown): Promise<void> {
  const timer = setTimeout(tell, SLOW_MS);
  return work.finally(() => clearTimeout(timer));
}

/** What a run needs of the app around it. */
export interface RunHost extends Pick<ClientOptions, 'createWorker' | 'firmware'> {
  /** The set-up of a run that starts now. @param kept that of a run that was kept, and is to be run again */
  setup(kept?: RunSetup): RunSetup;
  /** Place of the device whose board and program are shown. Left out: the first. */
  device?(): number;
  /** Whether nobody may do that; left out: all may be done. */
  refuses?(action: InputAction): boolean;
  /** Something was done to a board, whether a run takes it or not. */
  onInput(action: InputAction, device: number): void;
  onStart(): void;
  onOutput(output: Output): void;
  onEnded(ended: Ended, device: number): void;
  /** The program runs again from its start: Ctrl-D at the REPL. */
  onRestarted(device: number): void;
  /** What sounded, was sent by radio and was logged. */
  onEvents(events: RunEvents, device: number): void;
  /** The VM could not be loaded. @param why see `troubleOf` */
  onUnavailable(why: unknown): void;
  /** The VM lets wait for itself. */
  onSlow?(): void;
  onFailed(message: string): void;
  /** The run did not take an input; it goes on without it. */
  onRefused(message: string): void;
  onKilled(): void;
}

/** How a run begins. */
export interface Beginning {
  /** Of a run that has been and is to be run again; left out: a new one. */
  readonly kept?: RunSetup;
  readonly paused: boolean;
  /** Until this simulated time it runs as fast as it can. */
  readonly catchUpUs?: number;
  /** The run that is left for this one. */
  readonly left?: Recording | null;
  /** It was recorded before: when it has come there, it is looked at from its beginning on. */
  readonly brought?: BroughtTape | null;
  /** The moment that is shown until the run has caught up. */
  readonly shown?: Snapshot | null;
  /** The moment that is asked for meanwhile. */
  readonly asked?: Asked;
}

/**
 * The run as the page sees it. Reading costs nothing; every command goes to the worker and comes back as a change here.
 */
export class RunModel {
  readonly phase: ShallowRef<RunPhase> = shallowRef<RunPhase>('ready');
  /** The run now. */
  readonly present: ShallowRef<Snapshot | null> = shallowRef(null);
  /** Its moments that have been. */
  readonly look = new LookPort(this, () => {
    this.pause();
    this.client.send({ type: 'tape' });
  });
  /** The moment that is looked at instead of now; `null`: nobody looks back. Only `look` changes it. */
  readonly past = this.look.past;
  /** What is to be seen: the run now, or as it was. */
  readonly snapshot: ComputedRef<Snapshot | null> = computed(() => this.past.value ?? this.present.value);
  /** The same as the device that is shown has it: its board, its program and its robot in the first one's place. */
  readonly shown: ComputedRef<Snapshot | null> = computed(() => {
    const snapshot = this.snapshot.value;
    const device = this.deviceNow(this.device);
    return snapshot === null || device === null || device === snapshot ? snapshot : { ...snapshot, ...device };
  });
  /** The paths that the robots have taken; their contents change with `snapshot`. */
  readonly trails = new Trails();
  /** How each device's program has ended, by its place; missing before there is a run. */
  readonly endings: ShallowRef<readonly (Ended | null)[]> = shallowRef([]);
  /** How the program of the device that is shown has ended. */
  readonly ended: ComputedRef<Ended | null> = computed(() => this.endings.value[this.device] ?? null);
  readonly nowUs = computed(() => this.snapshot.value?.timeUs ?? 0);
  /** What is kept of the run to look back. */
  readonly recording: ShallowRef<Recording> = shallowRef(new Recording(null));
  /** The runs before this one; `null`: none was worth keeping yet. */
  readonly earlier: ShallowRef<EarlierRuns | null> = shallowRef(null);
  /** Simulated seconds per wall second reached lately; `null` while unknown. */
  readonly achieved: ShallowRef<number | null> = shallowRef(null);
  readonly isBusy = shallowRef(false);
  /** What every Run button does instead of starting, for a host that brings its program first; `null`: it starts. */
  readonly ask: ShallowRef<(() => void) | null> = shallowRef(null);
  readonly isActive = computed(() => ['starting', 'running', 'paused', 'stopping'].includes(this.phase.value));
  /** All programs have ended. */
  readonly hasEnded = computed(() => this.endings.value.length > 0 && !this.endings.value.includes(null));
  /** So they have, and the world goes on. */
  readonly isOver = computed(() => this.isActive.value && this.hasEnded.value);
  /** The program stands in `input()`: only the person can go on. */
  readonly isWaitingForInput = computed(
    () =>
      (this.phase.value === 'running' || this.phase.value === 'paused') &&
      this.ended.value === null &&
      this.shown.value?.awaitsInput === true,
  );
  /** Where it stops, and what the program's variables are then. */
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

  /** How workers are made, and the VM for them: for others who run something. */
  get engine(): Pick<RunHost, 'createWorker' | 'firmware'> {
    return this.host;
  }

  /** Makes the next run immediate. A failure is not reported here: the run will report it. */
  warmUp(): void {
    this.client.warmUp().catch(() => undefined);
  }

  /** For every Run button: runs the program, or asks a host that sends the program first. */
  press(): void {
    if (this.ask.value === null) void this.start();
    else this.ask.value();
  }

  /** Starts a new run, also during a run; with `paused` it starts paused. */
  start(paused = false): Promise<void> {
    return this.begin({ paused });
  }

  /** Starts a new run in one of all ways. */
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
   * Does something to the run from outside; if the run is still starting, at its first moment. Without a run nothing
   * happens.
   *
   * @param device its place; left out: the one that is shown, and for a packet by radio all of them
   * @returns whether it may be done at all
   */
  input(action: InputAction, device?: number): boolean {
    if (this.host.refuses?.(action) === true) return false;
    this.look.leave(); // what is done, is done now
    this.host.onInput(action, device ?? this.device);
    const place = device ?? (action.type === 'radio' ? null : this.device);
    const name = place === null || (place === 0 && action.type !== 'radio') ? undefined : this.names[place];
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
  /** The devices of the run, as it calls them. */
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

  /** The run has come to the moment from which it was to go on: now it is shown, and heard. */
  private endCatchingUp(nowUs: number): void {
    if (this.catchUpUs === 0 || nowUs < this.catchUpUs) return;
    this.catchUpUs = 0;
    if (!this.recording.value.isBrought) this.look.leave();
    else if (this.past.value !== null) this.look.back(); // the rest of its moments
  }

  private setEnded(device: number, ended: Ended | null): void {
    this.endings.value = this.endings.value.map((before, place) => (place === device ? ended : before));
  }

  /** Something is done to the run, which may wake it. @returns whether it was sent */
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
