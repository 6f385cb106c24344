import type { Snapshot } from '#simulation/snapshot';
import type { Ended } from '#simulation/simulation';
import type { Verdict } from '#simulation/verdict';

import type { Outside } from '../door';
import type { EmbeddedSimulator, HostSettings, Phase, SimulatorEvent } from '../simulator';
import { eventNames } from './event-schemas';
import { limits } from './limits';
import { displayText, msOf, plainLogEvent, plainPacket, plainRobot, plainSnapshot } from './plain-snapshot';
import type { Commands, EndedWord, EventName, Events } from './protocol';
import { PROTOCOL_VERSION } from './read-command';

/** What a message costs besides its text: a thousand of them a second at most. */
const MESSAGE_CHARACTERS = 200;
/** Frames of a screen do not come to the ms: one that is this much early counts. */
const EARLY_MS = 2;

/** Tells a host what happens, as far as it wants to know. */
export class Teller {
  private wanted: ReadonlySet<EventName> = new Set(eventNames);
  private snapshotMs = Infinity;
  private toldMs = -Infinity;
  /** The newest snapshot that was passed over. */
  private passedOver: Snapshot | null = null;
  /** Output that may be sent now, in characters; it fills up with time. */
  private room: number = limits.outputCharactersPerSecond;
  private roomMs: number;
  private omitted = 0;
  /** Whether the program runs whose end is to be told. */
  private awaitsEnd = false;

  constructor(
    private readonly simulator: Pick<EmbeddedSimulator, 'snapshot' | 'nowUs'>,
    private readonly outside: Outside,
  ) {
    this.roomMs = outside.nowMs();
  }

  /** Chooses events and the rate of snapshots; what is left out stays. */
  subscribe({ events, snapshotHz }: Commands['subscribe']['fields']): void {
    if (events !== undefined) this.wanted = new Set(events);
    if (snapshotHz !== undefined) this.snapshotMs = snapshotHz === 0 ? Infinity : 1000 / snapshotHz;
  }

  /** Passes on an event of the app. */
  tell(event: SimulatorEvent): void {
    switch (event.type) {
      case 'phase':
        return this.phase(event.phase);
      case 'started':
        this.awaitsEnd = true;
        this.passedOver = null;
        return this.send('started', {});
      case 'output':
        return this.output(event.text);
      case 'program-ended':
        return this.ended(endedWord(event.ended), event.ended, event.verdict);
      case 'program-restarted':
        this.awaitsEnd = true;
        return this.send('program-restarted', {});
      case 'radio':
        return this.send('radio', { packets: event.packets.map(plainPacket) });
      case 'log':
        return this.send('log', { events: event.events.map(plainLogEvent) });
      case 'snapshot':
        return this.snapshot(event.snapshot);
      case 'scene':
        return this.send('scene-changed', { name: event.scene.name, objects: event.scene.objects.length });
      case 'files':
        return this.send('files-changed', { names: event.files.map(({ name }) => name) });
      case 'sensed':
        return this.send('sensed', sensed(event.action));
      case 'settings':
        return this.settings(event.settings);
      case 'refused':
      case 'failed':
        return this.send(event.type, { message: event.message });
      default:
        event satisfies never;
    }
  }

  private phase(phase: Phase): void {
    const isOver = phase === 'stopped' || phase === 'killed' || phase === 'failed';
    if (this.omitted > 0 && phase !== 'running') this.sendOutput('');
    if (phase !== 'running' && phase !== 'starting') this.catchUp();
    this.send('phase', { phase });
    if (isOver && this.awaitsEnd && phase !== 'failed') {
      const verdict = this.simulator.snapshot()?.verdict ?? null;
      this.ended(phase === 'stopped' ? 'stopped' : 'stuck', null, verdict);
    }
    if (isOver || phase === 'ready') this.awaitsEnd = false;
  }

  private ended(word: EndedWord, ended: Ended | null, verdict: Verdict | null): void {
    this.awaitsEnd = false;
    if (this.omitted > 0) this.sendOutput('');
    this.catchUp();
    const snapshot = this.simulator.snapshot();
    const exception = ended?.exception ?? null;
    this.send('ended', {
      ended: word,
      exception: exception && {
        type: exception.type,
        message: exception.message,
        line: exception.line,
        traceback: exception.traceback,
      },
      atMs: msOf(ended?.timeUs ?? this.simulator.nowUs()),
      robot: snapshot?.robot ? plainRobot(snapshot.robot) : null,
      display: snapshot === null ? '' : displayText(snapshot.display),
      verdict,
    });
  }

  private snapshot(snapshot: Snapshot): void {
    if (this.snapshotMs === Infinity) return;
    const nowMs = this.outside.nowMs();
    if (nowMs - this.toldMs < this.snapshotMs - EARLY_MS) {
      this.passedOver = snapshot;
      return;
    }
    this.toldMs = nowMs;
    this.passedOver = null;
    this.send('snapshot', { snapshot: plainSnapshot(snapshot) });
  }

  /** The last picture before things stand still is told at any rate. */
  private catchUp(): void {
    const last = this.passedOver;
    this.passedOver = null;
    if (last !== null && this.snapshotMs !== Infinity) this.send('snapshot', { snapshot: plainSnapshot(last) });
  }

  /** A host that is slow must not drown: what comes faster than the limit is left out and counted. */
  private output(text: string): void {
    const nowMs = this.outside.nowMs();
    const { outputCharactersPerSecond: most } = limits;
    const passedMs = Math.max(0, nowMs - this.roomMs);
    this.room = Math.min(most, this.room + (passedMs / 1000) * most);
    this.roomMs = nowMs;
    if (this.room < MESSAGE_CHARACTERS + text.length) this.omitted += text.length;
    else this.sendOutput(text);
  }

  private sendOutput(text: string): void {
    const { omitted } = this;
    this.omitted = 0;
    this.room -= text.length + MESSAGE_CHARACTERS;
    this.send('output', omitted > 0 ? { text, omitted } : { text });
  }

  private settings(settings: HostSettings): void {
    const { language, theme, muted, parts, robot, robotOptions, device, firmware } = settings;
    const { speed, seed, reality, arenaSenses } = settings;
    const all = { language, theme, muted, parts, robot, robotOptions, device, firmware };
    const told = { ...all, speed, seed, reality, arenaSenses };
    if (isComplete(told)) this.send('settings-changed', { settings: told });
  }

  private send<N extends EventName>(type: N, data: Events[N]): void {
    if (this.wanted.has(type)) this.outside.post({ parcours: PROTOCOL_VERSION, type, ...data });
  }
}

/** How a program ended, as a word. */
export const endedWord = ({ kind }: Pick<Ended, 'kind'>): EndedWord => (kind === 'fault' ? 'panic' : kind);

function sensed(action: Extract<SimulatorEvent, { type: 'sensed' }>['action']): Events['sensed'] {
  switch (action.type) {
    case 'button':
      return { sensor: action.button === 'a' ? 'buttonA' : 'buttonB', value: action.down ? 1 : 0 };
    case 'touch':
      return { sensor: action.pad, value: action.down ? 1 : 0 };
    case 'sensor':
      return { sensor: action.id, value: action.value };
    default:
      return action satisfies never;
  }
}

const isComplete = <T extends object>(settings: T): settings is { [K in keyof T]-?: Exclude<T[K], undefined> } =>
  Object.values(settings).every((value) => value !== undefined);
