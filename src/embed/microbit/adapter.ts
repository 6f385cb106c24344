import * as v from 'valibot';

import { LANGUAGES, type Language } from '#core/languages';
import { filesByName, MAIN, newWork, type SourceFile } from '#project/project';
import { importsOf } from '#python/imports';
import { NO_ROBOT } from '#simulation/run-setup';
import type { InputAction } from '#simulation/input';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import { robotMeant } from '#simulation/robot-fit';

import type { RunPhase } from '#simulation/pace';
import type { Adapter, HostConnection } from '../adapter';
import { listenToFirst } from '../first-device';
import type { EmbeddedSimulator, HostSettings, Part, SimulatorEvent } from '../simulator';
import { filesOf } from './files';
import { LogColumns } from './log-columns';
import { LABEL_NAMES, microbitCommand, type MicrobitCommand, type MicrobitEvent, type MicrobitState } from './messages';
import { pressedId, StateModel } from './state';

/** The settings at the start, as in the official simulator: a new board, without the pupil's own settings. */
const PLAIN: HostSettings = {
  device: 'auto',
  firmware: '',
  robot: NO_ROBOT,
  robotOptions: {},
  reality: 0,
  seed: 1,
  ...newWork,
  speed: 1,
  muted: false,
};
const BOARD_ALONE: readonly Part[] = ['board'];

/**
 * Makes the protocol adapter for hosts of the micro:bit simulator.
 *
 * @param wish the settings of the page's address; they hold for every flash. If they name no robot, a program that
 *   imports a robot's library gets that robot, and an arena beside the board unless parts are named
 */
export function createMicrobitAdapter(
  simulator: EmbeddedSimulator,
  connection: HostConnection,
  wish: HostSettings = {},
): Adapter {
  return new MicrobitAdapter(simulator, connection, wish);
}

class MicrobitAdapter implements Adapter {
  private readonly state: StateModel;
  private readonly columns = new LogColumns();
  private readonly unlisten: () => void;
  /** A stop or another start was requested: further output of the program is not sent. */
  private isQuiet = false;
  /** A program was flashed; before that the board is empty. */
  private hasFiles = false;
  private isActive: boolean;
  private endsWithReturn = false;
  private isClosed = false;

  constructor(
    private readonly simulator: EmbeddedSimulator,
    private readonly connection: HostConnection,
    private readonly wish: HostSettings,
  ) {
    this.state = new StateModel(simulator.sensorWishes());
    this.isActive = isActive(simulator.phase());
    simulator.change({ ...PLAIN, parts: BOARD_ALONE, ...wish });
    simulator.onRunAsked(() => this.say({ kind: 'request_flash' }));
    this.unlisten = listenToFirst(simulator, (event) => this.hear(event));
    this.say({ kind: 'ready', state: this.state.whole(simulator.board()) });
  }

  receive(message: unknown): void {
    if (this.isClosed) return;
    const command = commandOf(message);
    if (command !== null) this.obey(command);
  }

  close(): void {
    if (this.isClosed) return;
    this.isClosed = true;
    this.unlisten();
    this.simulator.onRunAsked(null);
  }

  private obey(command: MicrobitCommand): void {
    switch (command.kind) {
      case 'config':
        this.configure(command.language, command.translations);
        break;
      case 'flash':
        this.flash(command.filesystem);
        break;
      case 'stop':
        this.stop();
        break;
      case 'reset':
        if (!this.hasFiles && this.load([{ name: MAIN, text: '' }]) !== null) break;
        this.start();
        break;
      case 'mute':
      case 'unmute':
        this.simulator.change({ muted: command.kind === 'mute' });
        break;
      case 'serial_input':
        if (command.data !== '') this.simulator.input({ type: 'serial', text: command.data });
        break;
      case 'radio_input':
        this.simulator.input({ type: 'radio', bytes: [...command.data] });
        break;
      case 'set_value':
        this.setValue(command.id, command.value);
        break;
      default:
        command satisfies never;
    }
  }

  private configure(language: string, translations: Readonly<Record<string, string>>): void {
    const words = LABEL_NAMES.flatMap((name) => {
      const word = translations[name];
      return word === undefined || word.trim() === '' ? [] : [[name, word] as const];
    });
    const own = ownLanguage(language);
    this.simulator.change({ ...(own === null ? {} : { language: own }), labels: Object.fromEntries(words) });
  }

  private flash(filesystem: Readonly<Record<string, Uint8Array>>): void {
    const read = filesOf(filesystem);
    if ('problem' in read) return this.sayError(read.problem);
    const problem = this.load(read.files);
    if (problem !== null) return this.sayError(problem);
    this.endRun();
    this.emptyLog();
    if (read.leftOut !== null) this.sayError(read.leftOut);
    this.start();
  }

  /** Puts files on the board, with the robot that they drive. @returns why not, or `null` */
  private load(files: readonly SourceFile[]): string | null {
    const { robot, parts } = this.simulator.settings();
    const wasQuiet = this.isQuiet;
    this.isQuiet = true;
    const problem = this.simulator.setFiles(files);
    if (problem !== null) {
      this.isQuiet = wasQuiet;
      return problem;
    }
    this.hasFiles = true;
    const wanted = this.surroundings(files);
    // Only what differs: every choice of a robot restarts.
    if (wanted.robot !== robot || wanted.parts.join() !== parts.join()) this.simulator.change(wanted);
    return null;
  }

  private surroundings(files: readonly SourceFile[]): { readonly robot: string; readonly parts: readonly Part[] } {
    const meant = robotMeant(importsOf(filesByName(files)), null);
    const robot = this.wish.robot ?? (meant === null ? NO_ROBOT : 'auto');
    const asked = this.wish.parts ?? BOARD_ALONE;
    const isPlain = asked.join() === BOARD_ALONE.join();
    return { robot, parts: isPlain && robot !== NO_ROBOT ? ['board', 'arena'] : asked };
  }

  private start(): void {
    this.endRun();
    this.isQuiet = true;
    void this.simulator.run();
  }

  /** The current run is over for the host, whatever of it is still to come. */
  private endRun(): void {
    if (this.isActive) this.sayAll();
    this.isActive = false;
    this.isQuiet = true;
  }

  private stop(): void {
    if (!isActive(this.simulator.phase())) return;
    this.isQuiet = true;
    void this.simulator.stop();
  }

  private setValue(id: string, given: number | string): void {
    const value = this.state.read(id, given);
    if (value === null) return;
    // A second press without a release is another press.
    if (isPressable(id) && Number(value) >= 0.5 && this.state.isDown(id)) this.feel(id, 0);
    this.feel(id, value);
  }

  private feel(id: string, value: number | string): void {
    if (this.simulator.input({ type: 'sensor', id, value }) === null) this.state.set(id, value);
  }

  private hear(event: SimulatorEvent): void {
    switch (event.type) {
      case 'phase':
        this.hearPhase(event.phase);
        break;
      case 'started':
        this.isQuiet = false;
        this.endsWithReturn = false;
        break;
      case 'output':
        this.print(event.text);
        break;
      case 'program-ended':
        if (event.ended.kind === 'panic') this.sayAll();
        break;
      case 'program-restarted':
        this.sayAll();
        break;
      case 'radio':
        if (!this.isQuiet) for (const packet of event.packets) this.tellPacket(packet);
        break;
      case 'log':
        if (!this.isQuiet) for (const one of event.events) this.tellLog(one);
        break;
      case 'snapshot':
        this.hearSnapshot(event.snapshot);
        break;
      case 'sensed':
        this.hearSensed(event.action);
        break;
      case 'failed':
        this.sayError(event.message);
        break;
      case 'scene':
      case 'files':
      case 'settings':
      case 'refused':
      case 'held':
      case 'looking':
      case 'break-points':
        break;
      default:
        event satisfies never;
    }
  }

  private hearPhase(phase: RunPhase): void {
    const was = this.isActive;
    this.isActive = phase === 'stopping' ? was : isActive(phase);
    if (phase === 'stopping') this.isQuiet = true;
    if (was && !this.isActive) this.sayAll();
  }

  private hearSnapshot(snapshot: Extract<SimulatorEvent, { type: 'snapshot' }>['snapshot']): void {
    if (this.isQuiet) return;
    if (this.state.setRadio(snapshot.radio.on, snapshot.radio.group)) this.sayChange('radio');
    if (this.state.setLogFull(snapshot.logFull)) this.sayChange('dataLogging');
    this.sayChange(...this.state.setLimits(snapshot));
  }

  /** The user of the page acted: a host's own values are not echoed. */
  private hearSensed(action: Extract<InputAction, { type: 'button' | 'touch' | 'sensor' }>): void {
    switch (action.type) {
      case 'button':
      case 'touch': {
        const id = pressedId(action.type === 'button' ? action.button : action.pad);
        this.state.set(id, action.down ? 1 : 0);
        return this.sayChange(id);
      }
      case 'sensor':
        this.state.set(action.id, action.value);
        return this.sayChange(action.id);
      default:
        action satisfies never;
    }
  }

  /** A packet, after its group. Snapshots, which also report the group, may come later or (page hidden) never. */
  private tellPacket({ group, bytes }: RadioPacket): void {
    if (this.state.setRadio(true, group)) this.sayChange('radio');
    this.say({ kind: 'radio_output', data: Uint8Array.from(bytes) });
  }

  private tellLog(event: TimedLogEvent): void {
    switch (event.type) {
      case 'clear':
        return this.emptyLog();
      case 'full':
        if (this.state.setLogFull(true)) this.sayChange('dataLogging');
        return;
      case 'row': {
        const message = this.columns.rowMessage(event.headings, event.values);
        if (message !== null) this.say(message);
        return;
      }
      default:
        event satisfies never;
    }
  }

  /** The log has room again before the host's table is empty, in the order of the official simulator. */
  private emptyLog(): void {
    this.columns.clear();
    if (this.state.setLogFull(false)) this.sayChange('dataLogging');
    this.say({ kind: 'log_delete' });
  }

  /** Lines end as on the board's serial line. */
  private print(text: string): void {
    if (this.isQuiet || text === '') return;
    const data = text.replace(/\r?\n/g, (end, at: number) =>
      at === 0 && end === '\n' && this.endsWithReturn ? '\n' : '\r\n',
    );
    this.endsWithReturn = text.endsWith('\r');
    this.say({ kind: 'serial_output', data });
  }

  private sayAll(): void {
    this.state.rest();
    this.say({ kind: 'state_change', change: this.state.whole(this.simulator.board()) });
  }

  private sayChange(...ids: readonly string[]): void {
    const change = Object.assign({}, ...ids.map((id) => this.state.only(id))) as MicrobitState;
    if (Object.keys(change).length > 0) this.say({ kind: 'state_change', change });
  }

  private sayError(message: string): void {
    this.say({ kind: 'internal_error', error: new Error(message) });
  }

  private say(message: MicrobitEvent): void {
    if (!this.isClosed) this.connection.post(message);
  }
}

/** The command in a message; `null` for anything that is not a command of this dialect. */
function commandOf(message: unknown): MicrobitCommand | null {
  try {
    const read = v.safeParse(microbitCommand, message);
    return read.success ? read.output : null;
  } catch {
    return null; // on the same page it may be an object that throws when it is read
  }
}

const isActive = (phase: RunPhase): boolean => ['starting', 'running', 'paused', 'stopping'].includes(phase);

const isPressable = (id: string): boolean => id.startsWith('button') || id.startsWith('pin');

/** The page's language for one of the host's, `fr` for `fr-CA`. */
function ownLanguage(language: string): Language | null {
  const [primary] = language.toLowerCase().split(/[-_]/);
  return LANGUAGES.find((own) => own === primary) ?? null;
}
