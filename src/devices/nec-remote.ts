/**
 * The infrared remote control of DFRobot's kit, 21 keys, in the NEC code. One key sends one frame, and while it is held
 * a short repeat frame every 110 ms:
 *
 *      ▇▇▇▇▇▇▇▇        ▇ ▇ ▇   ▇ … ▇          ▇ = burst of 38 kHz
 *        9 ms    4.5 ms  32 bits    end
 *
 *      bit        0.56 ms burst, then 0.56 ms of silence for 0, 1.69 ms for 1; lowest bit of each byte first
 *      bytes      00 BF (the address), the command, the command inverted
 *      repeat     9 ms burst, 2.25 ms of silence, 0.56 ms burst
 *
 * Sources: the maker's decoder for MakeCode (DFRobot pxt-maqueen, which takes 8 to 10 ms, 4 to 5 ms, 2 to 2.5 ms, bits of
 * 400 to 700 µs and 1500 to 1800 µs); the list of codes of tinysuperlab/MotionKitV2, in which key 1 is 00 FD 08 F7 when
 * each byte is read highest bit first.
 */
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** The keys in the order in which they stand on the remote control, three in a row, each with its command. */
export const remoteKeys = [
  ['power', 0],
  ['volumeUp', 1],
  ['func', 2],
  ['left', 4],
  ['play', 5],
  ['right', 6],
  ['down', 8],
  ['volumeDown', 9],
  ['up', 10],
  ['0', 12],
  ['eq', 13],
  ['repeat', 14],
  ['1', 16],
  ['2', 17],
  ['3', 18],
  ['4', 20],
  ['5', 21],
  ['6', 22],
  ['7', 24],
  ['8', 25],
  ['9', 26],
] as const;

/** A key by its name. */
export type RemoteKey = (typeof remoteKeys)[number][0];

const commands: ReadonlyMap<string, number> = new Map(remoteKeys);

/** The byte that a key sends. @throws RangeError for a name that no key has */
export function commandOf(key: RemoteKey): number {
  const command = commands.get(key);
  if (command === undefined) throw new RangeError(`The remote control has no key "${key}".`);
  return command;
}

/** True for the name of a key. */
export const isRemoteKey = (name: unknown): name is RemoteKey => typeof name === 'string' && commands.has(name);

/** The infrared light that falls on a receiver. */
export interface InfraredLight {
  /** Calls when a burst begins (`true`) and when it ends. */
  onBurst(listener: (isOn: boolean) => void): Stop;
}

/** A room in which nobody sends. */
export const noInfrared: InfraredLight = { onBurst: () => () => undefined };

const LEADER_US = 9000;
const LEADER_GAP_US = 4500;
const REPEAT_GAP_US = 2250;
const BURST_US = 560;
const ZERO_GAP_US = 560;
const ONE_GAP_US = 1690;
/** From the beginning of a frame to that of the next one. */
export const FRAME_PERIOD_US = 110_000;

const ADDRESS = [0x00, 0xbf] as const;
const BYTE = 0xff;

/** Lengths of the bursts and of the silences after them, in turn, in µs. */
type Pulses = readonly number[];

const REPEAT: Pulses = [LEADER_US, REPEAT_GAP_US, BURST_US];

function frameOf(command: number): Pulses {
  const bytes = [...ADDRESS, command, command ^ BYTE];
  const bits = bytes.flatMap((byte) => [0, 1, 2, 3, 4, 5, 6, 7].map((place) => (byte >> place) & 1));
  return [
    LEADER_US,
    LEADER_GAP_US,
    ...bits.flatMap((bit) => [BURST_US, bit === 1 ? ONE_GAP_US : ZERO_GAP_US]),
    BURST_US,
  ];
}

/** The key that was pressed last, and whether it still is. */
export interface SentKey {
  readonly key: RemoteKey;
  readonly isDown: boolean;
}

/** A remote control that points at one receiver. */
export class NecRemote implements InfraredLight {
  private readonly listeners = new Set<(isOn: boolean) => void>();
  private held: RemoteKey | null = null;
  private last: RemoteKey | null = null;
  /** Pressed while a frame was on its way: its own begins with the next period. */
  private waiting: RemoteKey | null = null;
  private isBusy = false;

  constructor(private readonly clock: Clock) {}

  /** The key that was pressed last; `null`: none yet. */
  get sent(): SentKey | null {
    return this.last && { key: this.last, isDown: this.held === this.last };
  }

  /** Presses a key or lets it go. Of several keys the one that was pressed last sends. */
  set(key: RemoteKey, isDown: boolean): void {
    if (!isDown) {
      if (this.held === key) this.held = null;
      return;
    }
    if (this.held === key) return;
    this.held = key;
    this.last = key;
    this.waiting = key;
    if (!this.isBusy) this.begin();
  }

  onBurst(listener: (isOn: boolean) => void): Stop {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  /** Begins a period with a frame, a repeat or, when no key is down, with nothing. */
  private begin(): void {
    this.isBusy = this.waiting !== null || this.held !== null;
    if (!this.isBusy) return;
    this.send(this.waiting === null ? REPEAT : frameOf(commandOf(this.waiting)), this.clock.nowUs);
    this.waiting = null;
    this.clock.at(this.clock.nowUs + FRAME_PERIOD_US, () => this.begin());
  }

  /** Sends the pulses from the given one on; an alarm for each edge. */
  private send(pulses: Pulses, atUs: number, place = 0): void {
    for (const listener of this.listeners) listener(place % 2 === 0);
    const length = pulses[place];
    if (length === undefined) return;
    const nextUs = atUs + length;
    this.clock.at(nextUs, () => this.send(pulses, nextUs, place + 1));
  }
}

/** A chip that understands the frames by itself. */
export interface NecDecoder {
  /**
   * The 32 bits of the last frame as makers' lists write them, each byte highest bit first in the order of sending; 0 once
   * nothing has come for longer than a period.
   */
  readonly code: () => number;
  readonly stop: Stop;
}

/** The last repeat must be so long ago that a key counts as let go. Chosen: one period and a margin for the edges. */
const SILENCE_US = FRAME_PERIOD_US + 10_000;
const BITS = 32;

/** Makes a decoder that listens to the light. */
export function attachNecDecoder(clock: Clock, light: InfraredLight): NecDecoder {
  let heard = 0;
  let heardUs = -Infinity;
  let bits: number | null = null;
  let count = 0;
  let edgeUs = 0;
  let burstUs = 0;
  const hear = (gapUs: number): void => {
    if (burstUs >= LEADER_US / 2) {
      bits = gapUs > LEADER_US / 3 ? 0 : null;
      count = 0;
      if (bits === null) heardUs = clock.nowUs;
    } else if (bits !== null) {
      bits = ((bits << 1) | (gapUs > 2 * ZERO_GAP_US ? 1 : 0)) >>> 0;
      count += 1;
      if (count < BITS) return;
      heard = bits;
      heardUs = clock.nowUs;
      bits = null;
    }
  };
  const stop = light.onBurst((isOn) => {
    const lengthUs = clock.nowUs - edgeUs;
    edgeUs = clock.nowUs;
    if (isOn) hear(lengthUs);
    else burstUs = lengthUs;
  });
  return { code: () => (clock.nowUs - heardUs <= SILENCE_US ? heard : 0), stop };
}
