import type { RadioConfig } from '#board/radio';
import { packetOfText } from '#board/radio-text';
import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import type { Device } from '../device';
import type { InputAction } from '../input';

/** A packet under way. */
interface Packet {
  /** Place of the sender among the devices. */
  readonly from: number;
  readonly bytes: Uint8Array;
  readonly config: RadioConfig;
  readonly startUs: number;
  readonly endUs: number;
}

/** Time of a byte in µs by data rate: 1 Mbit/s, 2 Mbit/s, 250 kbit/s. */
const BYTE_US = [8, 4, 32] as const;
/** Preamble, address (4 + 1), length and check sum (2) of a packet: nRF52833 product specification, RADIO, packet configuration. */
const FRAME_BYTES = 1 + 5 + 1 + 2;
/** Sent strength in dBm by `power`: nRF52833 product specification, RADIO TXPOWER, as micropython-microbit-v2 uses it. */
const POWER_DBM = [-30, -20, -16, -12, -8, -4, 0, 4] as const;
/** Received power of 0 dBm after a metre. Chosen: two micro:bits on a table; the antennas are on their boards. */
const AT_A_METRE_DBM = -50;
/** Nothing is nearer than two boards on each other, in m². */
const NEAREST_M2 = 0.05 * 0.05;
/** A decibel as a ratio of squared distances: 10^(1/10). */
const DECIBEL = 1.2589254117941673;
/** Half a decibel less: 10^(−1/20). */
const HALF_LESS = 0.8912509381337456;
/** Down to here a packet is understood: nRF52833 product specification, sensitivity at 1 Mbit/s. */
const SENSITIVITY_DBM = -95;

// At reality 1. Chosen: walls and hands make a reading waver by this much, and one packet in a hundred is lost.
const WAVERING_DB = 4;
const LOST = 0.01;
/** A packet this much stronger than another at the same time is understood all the same. Chosen: a usual figure for FSK. */
const CAPTURE_DB = 10;

/**
 * The air between the boards: what one sends, the others receive at the next step of the world, if their radios are on
 * the same channel, in the same group, with the same address and data rate. Strength falls with the square of the
 * distance. With *reality* it wavers, weak and some other packets are lost, and packets that overlap disturb each other.
 */
export class Air {
  /** Packets that were sent and are not delivered yet. */
  private flying: Packet[] = [];
  /** Packets sent shortly before, which may overlap with those in the air. */
  private past: readonly Packet[] = [];
  private readonly chance;

  /** @param placeOf where a device is, in mm */
  constructor(
    private readonly devices: readonly Device[],
    private readonly placeOf: (device: Device) => Vec,
    seed: number,
    private readonly reality: number,
  ) {
    this.chance = createRng(seed).fork('air');
    if (devices.length > 1) devices.forEach((device, from) => this.listenTo(device, from));
  }

  /** True if no packet is under way. */
  get isQuiet(): boolean {
    return this.flying.length === 0;
  }

  /** Delivers what has been sent up to `timeUs`. */
  step(timeUs: number): void {
    if (this.flying.length === 0) return;
    const over = this.flying.filter(({ endUs }) => endUs <= timeUs);
    if (over.length === 0) return;
    this.flying = this.flying.filter(({ endUs }) => endUs > timeUs);
    over.sort((a, b) => a.endUs - b.endUs || a.from - b.from);
    const heard = [...this.past, ...over, ...this.flying];
    for (const packet of over)
      this.devices.forEach((to, place) => {
        if (place !== packet.from && hears(to, packet)) this.deliver(packet, to, place, heard);
      });
    const earliestUs = Math.min(...this.flying.map(({ startUs }) => startUs), timeUs);
    this.past = heard.filter(({ endUs }) => endUs > earliestUs - LONGEST_US && endUs <= timeUs);
  }

  private listenTo({ board, clock }: Device, from: number): void {
    board.radio.onSend((bytes) => {
      const { config } = board.radio;
      const tookUs = (FRAME_BYTES + bytes.length) * (BYTE_US[config.dataRate] ?? BYTE_US[0]);
      this.flying.push({ from, bytes, config, startUs: clock.nowUs - tookUs, endUs: clock.nowUs });
    });
  }

  private deliver(packet: Packet, to: Device, place: number, heard: readonly Packet[]): void {
    const strength = this.strengthAt(packet, to);
    if (this.reality === 0) return to.board.radio.receive(packet.bytes, strength);
    // Drawn for every packet that could be heard, so that one that is lost changes nothing for the next.
    const [wavering, luck] = [2 * this.chance.unit() - 1, this.chance.unit()];
    const rssiDbm = Math.round(strength + this.reality * WAVERING_DB * wavering);
    if (rssiDbm < SENSITIVITY_DBM || luck < this.reality * LOST) return;
    const disturbs = (other: Packet): boolean =>
      other !== packet &&
      other.config.channel === packet.config.channel &&
      other.startUs < packet.endUs &&
      packet.startUs < other.endUs &&
      (other.from === place || this.strengthAt(other, to) > strength - CAPTURE_DB);
    if (!heard.some(disturbs)) to.board.radio.receive(packet.bytes, rssiDbm);
  }

  /** In dBm, whole: only products and comparisons, which every engine computes alike. */
  private strengthAt({ from, config }: Packet, to: Device): number {
    const sender = this.devices[from];
    const a = sender ? this.placeOf(sender) : { x: 0, y: 0 };
    const b = this.placeOf(to);
    const squaredM2 = Math.max(((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)) / 1e6, NEAREST_M2);
    let strength = AT_A_METRE_DBM + (POWER_DBM[config.power] ?? 0);
    let reachedM2 = HALF_LESS; // within half a decibel of a metre
    for (; squaredM2 >= reachedM2 * DECIBEL; reachedM2 *= DECIBEL) strength--;
    for (; squaredM2 < reachedM2; reachedM2 /= DECIBEL) strength++;
    return strength;
  }
}

/** The longest packet at the slowest rate. */
const LONGEST_US = (FRAME_BYTES + 251) * 32;

function hears({ board: { radio } }: Device, { config }: Packet): boolean {
  const own = radio.config;
  return (
    radio.isOn &&
    own.channel === config.channel &&
    own.group === config.group &&
    own.address === config.address &&
    own.dataRate === config.dataRate
  );
}

/** The packet of a message from outside. */
export const packetOf = (action: Extract<InputAction, { type: 'radio' }>): Uint8Array =>
  'bytes' in action ? Uint8Array.from(action.bytes) : packetOfText(action.text);
