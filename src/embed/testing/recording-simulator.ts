import { Board } from '#board/board';
import { Clock } from '#core/clock';
import { deviceNames, withFiles } from '#project/devices';
import { defaultProjectSettings, filesByName, MAIN, type Project, type SourceFile } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import { defaultScene } from '#scene/scene';
import { movableIds } from '#simulation/at-once';
import { chooseHardware, type Hardware } from '#simulation/hardware';
import type { InputAction } from '#simulation/input';
import type { RunPhase } from '#simulation/pace';
import { placeOfDevice } from '#simulation/several/place-of-device';
import { createInputCheck, type InputCheck } from '#simulation/run-problem';
import { SOLO } from '#simulation/run-setup';
import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';
import { boardSnapshot } from '#simulation/take-snapshot';

import { filesProblem } from '../files-problem';
import type { BreakPoint, EmbeddedDebugger, HostStep, ProgramMoment } from '../debugger';
import {
  PARTS,
  type ArenaMode,
  type EmbeddedSimulator,
  type HostSettings,
  type Refusal,
  type SimulatorEvent,
} from '../simulator';

/** One action of an adapter on the simulator. Reading is not recorded. */
export type RecordedCall =
  | { readonly call: 'openProject'; readonly project: Project }
  | { readonly call: 'setFiles'; readonly files: readonly SourceFile[]; readonly device?: string }
  | { readonly call: 'setScene'; readonly scene: Project['scene'] }
  | { readonly call: 'edit'; readonly edit: Parameters<EmbeddedSimulator['edit']>[0] }
  | { readonly call: 'change'; readonly settings: HostSettings }
  | { readonly call: 'enterMode'; readonly mode: ArenaMode }
  | { readonly call: 'run'; readonly paused: boolean }
  | { readonly call: 'stop' | 'reset' | 'pause' | 'resume' | 'step' | 'clearConsole' }
  | { readonly call: 'input'; readonly action: InputAction; readonly device?: string }
  | { readonly call: 'setBreakPoints'; readonly points: readonly BreakPoint[]; readonly device?: string }
  | { readonly call: 'stepLine'; readonly step: HostStep; readonly device?: string }
  | { readonly call: 'lookAt'; readonly timeUs: number }
  | { readonly call: 'lookNow' }
  | { readonly call: 'goOn'; readonly paused: boolean }
  | { readonly call: 'onRunAsked'; readonly isSet: boolean };

/** Its initial state; left out: as on a fresh page. */
export interface RecordingStart {
  readonly project?: Project;
  readonly phase?: RunPhase;
  readonly settings?: HostSettings;
  /** Its runs never get their VM: they start until they are stopped. */
  readonly hangs?: boolean;
}

/**
 * A simulator for tests of protocol adapters. It keeps the work, the settings and the phase as the app does, and
 * refuses what the app refuses. It runs no program, and records its calls. `tell` stands in for everything that a
 * program would do.
 */
export class RecordingSimulator implements EmbeddedSimulator {
  /** The recorded actions, in order; refused ones are among them. */
  readonly calls: RecordedCall[] = [];
  /** Number of present listeners. */
  get listenerCount(): number {
    return this.listeners.size;
  }
  /** The host's words for the page. */
  labels: Readonly<Record<string, string>> = {};
  private readonly listeners = new Set<(event: SimulatorEvent) => void>();
  private ask: (() => void) | null = null;
  private entered: ArenaMode = 'drive';
  private work: Project;
  private held: ReturnType<EmbeddedSimulator['settings']>;
  private now: RunPhase;
  private rehearsal: Board;
  private wishes: Readonly<Record<string, number>> = {};
  private readonly hangs: boolean;
  private endStart = (): void => undefined;

  constructor({ project, phase = 'ready', settings = {}, hangs = false }: RecordingStart = {}) {
    this.hangs = hangs;
    this.work = project ?? { files: [{ name: MAIN, text: '' }], scene: defaultScene(), course: null };
    this.held = {
      ...defaultProjectSettings,
      ...{ language: 'en', theme: 'system', speed: 1, muted: false, parts: PARTS },
      ...settings,
    };
    this.now = phase;
    this.rehearsal = this.newBoard();
  }

  /** Sends an event of the app to all listeners. A `phase` is also the phase from now on. */
  tell(event: SimulatorEvent): void {
    if (event.type === 'phase') this.now = event.phase;
    for (const listener of [...this.listeners]) listener(event);
  }

  /** The user presses the page's Run button. @returns whether a host was asked; otherwise it ran. */
  pressRun(): boolean {
    if (this.ask === null) void this.run();
    else this.ask();
    return this.ask !== null;
  }

  phase = (): RunPhase => this.now;
  nowUs = (): number => 0;
  ended = (): null => null;
  board = (): string => this.hardware().board.id;
  mode = (): ArenaMode => this.entered;
  project = (): Project => ({ ...this.work, settings: projectSettings(this.held) });
  settings = (): ReturnType<EmbeddedSimulator['settings']> => this.held;
  sensorWishes = (): Readonly<Record<string, number>> => this.wishes;

  /** The board with its present sensors; `null` while everything is at the start. */
  snapshot(): Snapshot | null {
    if (this.now === 'ready') return null;
    const device: DeviceSnapshot = {
      ...boardSnapshot(this.rehearsal),
      ...{ name: SOLO, running: 'program', awaitsInput: false, repl: false, position: null, robot: null, lights: [] },
      arenaSenses: false,
    };
    const others = deviceNames(this.work)
      .slice(1)
      .map((name) => ({ ...device, name }));
    return { ...device, timeUs: 0, others, blocks: {}, movers: {}, verdict: null };
  }

  openProject(project: Project): Refusal {
    this.calls.push({ call: 'openProject', project });
    const problem = filesProblem(project.files);
    if (problem !== null) return problem;
    this.over('ready');
    this.work = project;
    if (project.settings !== undefined) this.held = { ...this.held, ...project.settings };
    this.rehearsal = this.newBoard();
    this.tell({ type: 'files', files: project.files });
    this.tell({ type: 'scene', scene: project.scene });
    return null;
  }

  setFiles(files: readonly SourceFile[], device?: string): Refusal {
    this.calls.push({ call: 'setFiles', files, ...(device !== undefined && { device }) });
    const place = placeOfDevice(deviceNames(this.work), device);
    const problem = filesProblem(files) ?? (typeof place === 'string' ? place : null);
    if (problem !== null) return problem;
    this.over('ready');
    this.work = withFiles(this.work, Number(place), files);
    this.rehearsal = this.newBoard();
    this.tell({ type: 'files', files, ...(device !== undefined && { device }) });
    return null;
  }

  setScene(scene: Project['scene']): Refusal {
    this.calls.push({ call: 'setScene', scene });
    this.over('ready');
    this.work = { ...this.work, scene, course: null };
    this.tell({ type: 'scene', scene });
    return null;
  }

  edit(edit: Parameters<EmbeddedSimulator['edit']>[0]): Refusal {
    this.calls.push({ call: 'edit', edit });
    const problem = editProblem(this.work.scene, edit);
    if (problem !== null) return problem.message;
    this.work = { ...this.work, scene: applyEdit(this.work.scene, edit) };
    this.tell({ type: 'scene', scene: this.work.scene });
    return null;
  }

  change(settings: HostSettings): Refusal {
    this.calls.push({ call: 'change', settings });
    const unknown = settings.parts?.find((part) => !PARTS.includes(part));
    if (unknown !== undefined) return `parts: "${unknown}" is not one of ${PARTS.join(', ')}.`;
    const { labels, ...kept } = settings;
    this.labels = labels ?? this.labels;
    const next = { ...this.held, ...kept };
    const chosen = chooseHardware(wishOf(this.work, next));
    if ('problem' in chosen) return chosen.problem;
    this.held = next;
    this.rehearsal = this.newBoard();
    this.tell({ type: 'settings', settings: this.held });
    return null;
  }

  enterMode(mode: ArenaMode): Refusal {
    this.calls.push({ call: 'enterMode', mode });
    if (mode === 'lookBack' && this.now === 'ready') return NO_RUN;
    this.entered = mode;
    return null;
  }

  async run(paused = false): Promise<Refusal> {
    this.calls.push({ call: 'run', paused });
    this.rehearsal = this.newBoard();
    this.tell({ type: 'phase', phase: 'starting' });
    this.tell({ type: 'started' });
    if (this.hangs) {
      await new Promise<void>((end) => (this.endStart = end));
      return 'The run was stopped before it began.';
    }
    await Promise.resolve();
    if (this.phase() !== 'starting') return 'The run was stopped before it began.';
    this.tell({ type: 'phase', phase: paused ? 'paused' : 'running' });
    return null;
  }

  async stop(): Promise<void> {
    this.calls.push({ call: 'stop' });
    await Promise.resolve();
    this.over('stopped');
  }

  async reset(): Promise<void> {
    this.calls.push({ call: 'reset' });
    await Promise.resolve();
    this.over('ready');
  }

  pause = (): Refusal => this.turn('pause', 'running', 'paused');
  resume = (): Refusal => this.turn('resume', 'paused', 'running');

  step(): Refusal {
    this.calls.push({ call: 'step' });
    this.tell({ type: 'phase', phase: 'paused' });
    return null;
  }

  input(action: InputAction, device?: string): Refusal {
    this.calls.push({ call: 'input', action, ...(device !== undefined && { device }) });
    const place = placeOfDevice(deviceNames(this.work), device);
    if (typeof place === 'string') return place;
    const problem = this.inputCheck()(action, this.work.scene, movableIds(new Set(), this.work.scene, this.work.scene));
    if (problem !== null || action.type !== 'sensor') return problem;
    const { sensors } = this.rehearsal;
    sensors.set(action.id, sensors.nearest(action.id, action.value));
    if (typeof action.value === 'number') this.wishes = { ...this.wishes, [action.id]: action.value };
    return null;
  }

  /** The place of every device's program; a text: the reason why it is unknown; `null`: the run does not answer. */
  where: ProgramMoment | string | null = 'This needs a run; it is "ready".';
  private points: readonly BreakPoint[] = [];
  private pastUs: number | null = null;
  readonly debug: EmbeddedDebugger = {
    breakPoints: (device) => this.deviceProblem(device) ?? this.points,
    setBreakPoints: async (points, device) => {
      await Promise.resolve();
      this.calls.push({ call: 'setBreakPoints', points, ...(device !== undefined && { device }) });
      const problem = this.deviceProblem(device);
      if (problem === null) this.points = points;
      return problem;
    },
    moment: (device) => {
      const given = this.deviceProblem(device) ?? this.where;
      return given === null ? new Promise((end) => (this.endStart = () => end('The run was stopped.'))) : Promise.resolve(given); // prettier-ignore
    },
    step: async (step, device) => {
      await Promise.resolve();
      this.calls.push({ call: 'stepLine', step, ...(device !== undefined && { device }) });
      return this.deviceProblem(device) ?? (this.now === 'paused' ? null : `This needs a run that is paused; it is ${this.now}.`); // prettier-ignore
    },
    lookAt: async (timeUs) => {
      await Promise.resolve();
      this.calls.push({ call: 'lookAt', timeUs });
      if (this.now === 'ready') return NO_RUN;
      this.pastUs = timeUs;
      this.tell({ type: 'looking', timeUs });
      return null;
    },
    lookNow: () => {
      this.calls.push({ call: 'lookNow' });
      this.pastUs = null;
      return null;
    },
    goOn: async (paused) => {
      await Promise.resolve();
      this.calls.push({ call: 'goOn', paused });
      return this.pastUs === null ? 'This needs a moment of the past.' : null;
    },
    isLookingBack: () => this.pastUs !== null,
  };

  clearConsole(): void {
    this.calls.push({ call: 'clearConsole' });
  }

  onRunAsked(ask: (() => void) | null): void {
    this.calls.push({ call: 'onRunAsked', isSet: ask !== null });
    this.ask = ask;
  }

  listen(listener: (event: SimulatorEvent) => void): () => void {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  private deviceProblem(device: string | undefined): Refusal {
    const place = placeOfDevice(deviceNames(this.work), device);
    return typeof place === 'string' ? place : null;
  }

  private turn(call: 'pause' | 'resume', from: RunPhase, to: RunPhase): Refusal {
    this.calls.push({ call });
    if (this.now !== from) return `This needs a run that is ${from}; it is "${this.now}".`;
    this.tell({ type: 'phase', phase: to });
    return null;
  }

  private over(phase: 'ready' | 'stopped'): void {
    this.endStart();
    const isActive = ['starting', 'running', 'paused', 'stopping'].includes(this.now);
    if (isActive) this.tell({ type: 'phase', phase: 'stopped' });
    if (phase === 'ready' && this.now !== 'ready') this.tell({ type: 'phase', phase });
  }

  /** The hardware for a run of the present work; only the first board if the course names unknown things. */
  private hardware(): Hardware {
    const chosen = chooseHardware(wishOf(this.work, this.held));
    if (!('problem' in chosen)) return chosen;
    const plain = chooseHardware({ scene: defaultScene(), imports: new Set(), robot: 'none', board: 'auto' });
    if ('problem' in plain) throw new Error(plain.problem);
    return plain;
  }

  /** Made once for each board and course: fuzz tests call it a million times. */
  private inputCheck(): InputCheck {
    const { checked } = this;
    if (checked?.board === this.rehearsal && checked.scene === this.work.scene) return checked.check;
    const check = createInputCheck(this.hardware(), this.work.scene);
    this.checked = { board: this.rehearsal, scene: this.work.scene, check };
    return check;
  }
  private checked: { readonly board: Board; readonly scene: Project['scene']; readonly check: InputCheck } | null =
    null;

  private newBoard(): Board {
    const { board, firmware } = this.hardware();
    const made = new Board(board, new Clock(), firmware);
    for (const [id, value] of Object.entries(this.wishes)) {
      if (made.sensors.ids.includes(id)) made.sensors.set(id, made.sensors.nearest(id, value));
    }
    return made;
  }
}

/** The refusal of a past. */
const NO_RUN = 'This needs a run that has been.';

function wishOf({ scene, files }: Project, settings: ReturnType<EmbeddedSimulator['settings']>) {
  const { robot, device, robotOptions } = settings;
  const board = device === 'calliope-mini-2' ? 'calliope-mini-3' : device; // as the app: its programs run on the mini 3
  const imports = modulesImportedBy(filesByName(files));
  return { scene, imports, robot, board, robotOptions: robotOptions[robot] ?? {} };
}

function projectSettings(settings: ReturnType<EmbeddedSimulator['settings']>) {
  const { device, firmware, robot, robotOptions, reality, seed, arenaSenses } = settings;
  return { device, firmware, robot, robotOptions, reality, seed, arenaSenses };
}
