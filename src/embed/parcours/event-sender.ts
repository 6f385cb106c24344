import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { RunPhase } from '#simulation/pace';
import { displayText, endedWord, msOf, packetReport, type EndedWord } from '#simulation/report';
import type { Ended } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

import type { HostConnection } from '../adapter';
import type { EmbeddedSimulator, HostSettings, SimulatorEvent } from '../simulator';
import { RateLimit } from './rate-limit';
import { eventNames } from './event-schemas';
import { plainLogEvent, plainRobot, plainSnapshot } from './plain-snapshot';
import type { Commands, EventName, Events, OfDevice, PlainLogEvent, PlainPacket } from './protocol';
import { PROTOCOL_VERSION } from './read-command';

/** Frames of a screen are not regular to the ms: one that is this much early counts. */
const EARLY_MS = 2;

/** Cost of a packet or a row besides its content, in characters. */
const ENTRY_CHARACTERS = 50;
/** Cost of a number in a list, in characters. */
const NUMBER_CHARACTERS = 4;

/**
 * Sends events to a host, as far as it has subscribed. A slow host must not be flooded by a program: output, packets
 * and rows have a rate limit each. All other events come at most as often as the page is drawn or commanded.
 */
export class EventSender {
  private wanted: ReadonlySet<EventName> = new Set(eventNames);
  private snapshotMs = Infinity;
  private toldMs = -Infinity;
  /** The newest snapshot that was skipped. */
  private passedOver: Snapshot | null = null;
  /** By the name of a further device, and by an empty text for the first. */
  private readonly rates = new Map<string, DeviceRates>();
  /** True if there is a run whose programs' ends must be reported. */
  private awaitsEnd = false;
  /** The devices whose programs have ended, by name as above. */
  private readonly over = new Set<string>();

  constructor(
    private readonly simulator: Pick<EmbeddedSimulator, 'snapshot' | 'nowUs'>,
    private readonly connection: HostConnection,
  ) {}

  /** Chooses events and the rate of snapshots; settings that are left out stay. */
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
        this.over.clear();
        this.passedOver = null;
        return this.send('started', {});
      case 'output':
        return this.output(event.text, from(event));
      case 'program-ended':
        return this.ended(endedWord(event.ended), event.ended, event.verdict, from(event));
      case 'program-restarted':
        this.awaitsEnd = true;
        this.over.delete(event.device ?? FIRST);
        return this.send('program-restarted', from(event));
      case 'radio':
        return this.radio(event.packets, event.dropped ?? 0, from(event));
      case 'log':
        return this.log(event.events, from(event));
      case 'held': {
        const { file, line } = event;
        return this.send('held', { atMs: msOf(event.timeUs), file, line, ...from(event) });
      }
      case 'looking':
        return this.send('looking', { atMs: event.timeUs === null ? null : msOf(event.timeUs) });
      case 'break-points':
        return this.send('break-points-changed', { points: event.points, ...from(event) });
      case 'snapshot':
        return this.snapshot(event.snapshot);
      case 'scene':
        return this.send('scene-changed', { name: event.scene.name, objects: event.scene.objects.length });
      case 'files':
        return this.send('files-changed', { names: event.files.map(({ name }) => name), ...from(event) });
      case 'sensed':
        return this.send('sensed', { ...sensed(event.action), ...from(event) });
      case 'settings':
        return this.settings(event.settings);
      case 'refused':
      case 'failed':
        return this.send(event.type, { message: event.message });
      default:
        event satisfies never;
    }
  }

  private phase(phase: RunPhase): void {
    const isOver = phase === 'stopped' || phase === 'killed' || phase === 'failed';
    if (phase !== 'running') this.tellOmitted();
    if (phase !== 'running' && phase !== 'starting') this.catchUp();
    this.send('phase', { phase });
    if (isOver && this.awaitsEnd && phase !== 'failed') this.endAll(phase === 'stopped' ? 'stopped' : 'stuck');
    if (isOver || phase === 'ready') this.awaitsEnd = false;
  }

  /** Reports the end of every program that has not ended by itself. */
  private endAll(word: EndedWord): void {
    const snapshot = this.simulator.snapshot();
    const further = snapshot?.others.map(({ name }) => ({ device: name })) ?? [];
    for (const device of [{}, ...further])
      if (!this.over.has(keyOf(device))) this.ended(word, null, snapshot?.verdict ?? null, device);
  }

  private ended(word: EndedWord, ended: Ended | null, verdict: Verdict | null, device: OfDevice): void {
    this.over.add(keyOf(device));
    this.tellOmitted();
    this.catchUp();
    const all = this.simulator.snapshot();
    const snapshot = device.device === undefined ? all : all?.others.find(({ name }) => name === device.device);
    this.send('ended', {
      ...device,
      ended: word,
      exception: ended?.exception ?? null,
      atMs: msOf(ended?.timeUs ?? this.simulator.nowUs()),
      robot: snapshot?.robot ? plainRobot(snapshot.robot) : null,
      display: snapshot ? displayText(snapshot.display) : '',
      verdict,
    });
  }

  private snapshot(snapshot: Snapshot): void {
    if (this.snapshotMs === Infinity) return;
    const nowMs = this.connection.nowMs();
    if (nowMs - this.toldMs < this.snapshotMs - EARLY_MS) {
      this.passedOver = snapshot;
      return;
    }
    this.toldMs = nowMs;
    this.passedOver = null;
    this.send('snapshot', { snapshot: plainSnapshot(snapshot) });
  }

  /** The last snapshot before everything stands still is always sent. */
  private catchUp(): void {
    const last = this.passedOver;
    this.passedOver = null;
    if (last !== null && this.snapshotMs !== Infinity) this.send('snapshot', { snapshot: plainSnapshot(last) });
  }

  private output(text: string, device: OfDevice): void {
    const { output: rate } = this.ratesOf(device);
    if (!this.wanted.has('output')) return;
    if (rate.hasRoom(this.connection.nowMs()) && rate.take(text.length))
      this.send('output', { ...device, text, ...rate.send() });
    else rate.omit(text.length);
  }

  private radio(packets: readonly RadioPacket[], dropped: number, device: OfDevice): void {
    const { radio: rate } = this.ratesOf(device);
    if (!this.wanted.has('radio')) return;
    rate.omit(dropped);
    const plain = packets.map(packetReport);
    const hasRoom = rate.hasRoom(this.connection.nowMs());
    const found = hasRoom ? plain.findIndex((packet) => !rate.take(sizeOf(packet))) : 0;
    const sent = found < 0 ? plain : plain.slice(0, found);
    if (sent.length > 0) this.send('radio', { ...device, packets: sent, ...rate.send() });
    rate.omit(plain.length - sent.length);
  }

  /** Events that the log was emptied or is full are always sent: they say what the rows are worth. */
  private log(events: readonly TimedLogEvent[], device: OfDevice): void {
    const { log: rate } = this.ratesOf(device);
    if (!this.wanted.has('log')) return;
    let hasRoom = rate.hasRoom(this.connection.nowMs());
    const sent: PlainLogEvent[] = [];
    let omitted = 0;
    for (const event of events.map(plainLogEvent)) {
      if (event.type === 'row') hasRoom &&= rate.take(rowSize(event));
      if (event.type !== 'row' || hasRoom) sent.push(event);
      else omitted += 1;
    }
    if (sent.length > 0) this.send('log', { ...device, events: sent, ...rate.send() });
    rate.omit(omitted);
  }

  /** Reports the omissions since the last message in a message of its own. */
  private tellOmitted(): void {
    for (const [name, { output, radio, log }] of this.rates) {
      const device = name === FIRST ? {} : { device: name };
      if (output.hasOmitted) this.send('output', { ...device, text: '', ...output.send() });
      if (radio.hasOmitted) this.send('radio', { ...device, packets: [], ...radio.send() });
      if (log.hasOmitted) this.send('log', { ...device, events: [], ...log.send() });
    }
  }

  private ratesOf(device: OfDevice): DeviceRates {
    const key = keyOf(device);
    const nowMs = this.connection.nowMs();
    const rates = this.rates.get(key) ?? { output: new RateLimit(nowMs), radio: new RateLimit(nowMs), log: new RateLimit(nowMs) }; // prettier-ignore
    this.rates.set(key, rates);
    return rates;
  }

  private settings(settings: HostSettings): void {
    const { language, theme, muted, parts, robot, robotOptions, device, firmware } = settings;
    const { speed, seed, reality, arenaSenses } = settings;
    const all = { language, theme, muted, parts, robot, robotOptions, device, firmware };
    const told = { ...all, speed, seed, reality, arenaSenses };
    if (isComplete(told)) this.send('settings-changed', { settings: told });
  }

  private send<N extends EventName>(type: N, data: Events[N]): void {
    if (this.wanted.has(type)) this.connection.post({ parcours: PROTOCOL_VERSION, type, ...data });
  }
}

/** The first device in lists by name: a further one's name is never empty. */
const FIRST = '';
const keyOf = ({ device }: OfDevice): string => device ?? FIRST;

/** The device of an event, for a message. */
const from = ({ device }: OfDevice): OfDevice => (device === undefined ? {} : { device });

/** The rate limits of one device, per second. */
type DeviceRates = Readonly<Record<'output' | 'radio' | 'log', RateLimit>>;

const sizeOf = (packet: PlainPacket): number =>
  ENTRY_CHARACTERS + ('text' in packet ? packet.text.length : NUMBER_CHARACTERS * packet.bytes.length);

const rowSize = ({ headings, values }: Extract<PlainLogEvent, { type: 'row' }>): number =>
  ENTRY_CHARACTERS + [...headings, ...values].join('  ').length;

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
