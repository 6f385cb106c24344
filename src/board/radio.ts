import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Settings of the radio. Boards receive each other if they share channel, address, group and data rate. */
export interface RadioConfig {
  /** Longest message in bytes, 1 … 251. */
  readonly length: number;
  /** Capacity of the receive queue in messages of full length, 1 … 254. */
  readonly queue: number;
  /** 0 … 83, 1 MHz apart. */
  readonly channel: number;
  /** 0 … 7, weakest to strongest. */
  readonly power: number;
  /** 32 bits, unsigned. */
  readonly address: number;
  /** 0 … 255. */
  readonly group: number;
  /** 0 = 1 Mbit/s, 1 = 2 Mbit/s, 2 = 250 kbit/s (as the chip numbers them). */
  readonly dataRate: number;
}

/** Settings after a start: micropython-microbit-v2 drv_radio.h. */
export const START_RADIO: RadioConfig = {
  length: 32,
  queue: 3,
  channel: 7,
  power: 6,
  address: 0x75626974,
  group: 0,
  dataRate: 0,
};

/** A message that has been received. */
export interface RadioMessage {
  readonly bytes: Uint8Array;
  /** Strength at which it arrived, in dBm. */
  readonly rssiDbm: number;
  readonly timeUs: number;
}

const RSSI_DBM = -50; // chosen: another board some metres away in the same room
const OVERHEAD_BYTES = 6; // drv_radio.c: length, strength and time are stored with each message

/**
 * The radio: packets out, packets in. Senders outside are on the same channel and in the same group.
 *
 * Settings take effect when the radio is switched on or configured while on; `forget` alone changes nothing yet, as on
 * the device (modradio.c). Received messages share a buffer of `queue` messages of full length, so that more short ones
 * fit; when it is full, arriving messages are lost (drv_radio.c).
 */
export class Radio {
  private wanted = START_RADIO;
  /** The chip's settings; `null` while it is off. */
  private active: RadioConfig | null = null;
  private waiting: RadioMessage[] = [];
  private readonly listeners: ((packet: Uint8Array) => void)[] = [];

  constructor(private readonly clock: Clock) {}

  get isOn(): boolean {
    return this.active !== null;
  }

  get group(): number {
    return this.config.group;
  }

  get channel(): number {
    return this.config.channel;
  }

  /** Its settings, or those for when it is switched on. */
  get config(): RadioConfig {
    return this.active ?? this.wanted;
  }

  /** Bytes that messages may take while they wait, the one being sent included: the device takes them from its heap. */
  get bufferBytes(): number {
    return (this.wanted.length + OVERHEAD_BYTES) * (this.wanted.queue + 1);
  }

  /** Changes settings; a new length or queue size empties the queue. */
  configure(changes: Partial<RadioConfig>): void {
    const before = this.wanted;
    this.wanted = { ...before, ...changes };
    if (this.active === null) return;
    if (before.length !== this.wanted.length || before.queue !== this.wanted.queue) this.waiting = [];
    this.active = this.wanted;
  }

  /** Resets the settings to those of the start, for the next `on` or `configure`. */
  forget(): void {
    this.wanted = START_RADIO;
  }

  /** Switches it on, with an empty queue. */
  on(): void {
    this.active = this.wanted;
    this.waiting = [];
  }

  /** Switches it off; waiting messages are lost. */
  off(): void {
    this.active = null;
    this.waiting = [];
  }

  /** Sends one packet, cut to the longest length. Does nothing while the radio is off. */
  send(bytes: Uint8Array): void {
    if (!this.active) return;
    const packet = bytes.slice(0, this.active.length);
    for (const tell of [...this.listeners]) tell(packet);
  }

  /** Receives a packet, cut to the longest length. It is lost while the radio is off or the queue is full. */
  receive(packet: Uint8Array, rssiDbm = RSSI_DBM): void {
    if (!this.active) return;
    const bytes = packet.slice(0, this.active.length);
    const used = this.waiting.reduce((sum, message) => sum + message.bytes.length + OVERHEAD_BYTES, 0);
    const room = (this.active.length + OVERHEAD_BYTES) * this.active.queue;
    if (used + bytes.length + OVERHEAD_BYTES > room) return;
    this.waiting.push({ bytes, rssiDbm, timeUs: this.clock.nowUs });
  }

  /** The oldest waiting message; it stays in the queue. */
  get oldest(): RadioMessage | null {
    return this.waiting[0] ?? null;
  }

  /** Takes the oldest message out of the queue. */
  take(): RadioMessage | null {
    return this.waiting.shift() ?? null;
  }

  /** Reports every packet that is sent, as it is on the air. */
  onSend(listener: (packet: Uint8Array) => void): Stop {
    this.listeners.push(listener);
    return () => {
      const place = this.listeners.indexOf(listener);
      if (place >= 0) this.listeners.splice(place, 1);
    };
  }

  /** Back to the state after a start: off, with the first settings. Listeners outside stay. */
  reset(): void {
    this.forget();
    this.off();
  }
}
