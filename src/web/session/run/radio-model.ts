import { shallowRef, type ShallowRef } from 'vue';

import { textBytesOf } from '#board/radio-text';
import type { RadioPacket } from '#simulation/outlets';

import type { RunModel } from './run-model';

/** One packet in the list. */
export interface RadioEntry {
  readonly id: number;
  /** Simulated time. */
  readonly timeUs: number;
  /** Sent by a program, or by hand to all of them. */
  readonly from: 'program' | 'hand';
  /** Place of the device whose program sent it; 0 if it was sent by hand. */
  readonly device: number;
  /** Its text, or its bytes as hexadecimal digits if it has none. */
  readonly text: string;
  readonly isText: boolean;
  /** Sent by hand while the radio of the device that is shown was off: it was not received there. */
  readonly isLost?: true;
}

/** Maximum number of packets in the list. Chosen: more than anyone reads, few enough to draw. */
export const RADIO_ENTRIES = 200;

/**
 * Longest text of a message, in bytes, with the radio's default settings: 32 (modradio.c), less the 3 before a text.
 */
export const USUAL_TEXT_BYTES = 29;

/** The same for `radio.config(length=251)`, the longest there is. */
export const MOST_TEXT_BYTES = 248;

/** The radio traffic of this run, oldest packet first: sent by the programs, and by hand to them. */
export class RadioModel {
  readonly entries: ShallowRef<readonly RadioEntry[]> = shallowRef([]);
  /** Older packets have been dropped. */
  readonly isCut = shallowRef(false);
  private nextId = 1;

  constructor(private readonly run: Pick<RunModel, 'input' | 'nowUs'>) {}

  /** Adds packets of a device's program. @param dropped number of earlier packets that were lost */
  take(packets: readonly RadioPacket[], dropped: number, device = 0): void {
    if (dropped > 0) this.isCut.value = true;
    if (packets.length === 0) return;
    this.add(packets.map(({ timeUs, bytes }) => ({ timeUs, from: 'program' as const, device, ...readable(bytes) })));
  }

  /** Sends a text to all programs. @param heard whether the radio of the device that is shown is on */
  send(text: string, heard = true): void {
    this.run.input({ type: 'radio', text });
    const sent = { timeUs: this.run.nowUs.value, from: 'hand', device: 0, text, isText: true } as const;
    this.add([{ ...sent, ...(!heard && { isLost: true }) }]);
  }

  clear(): void {
    this.entries.value = [];
    this.isCut.value = false;
  }

  private add(news: readonly Omit<RadioEntry, 'id'>[]): void {
    const all = [...this.entries.value, ...news.map((entry) => ({ ...entry, id: this.nextId++ }))];
    all.sort((one, other) => one.timeUs - other.timeUs); // each device's packets arrive separately
    if (all.length > RADIO_ENTRIES) this.isCut.value = true;
    this.entries.value = all.slice(-RADIO_ENTRIES);
  }
}

/** A packet as people read it: the text of `radio.send`, or else the bytes in hexadecimal. */
export function readable(bytes: readonly number[]): Pick<RadioEntry, 'text' | 'isText'> {
  const textBytes = textBytesOf(bytes);
  if (textBytes !== null) {
    try {
      return { text: new TextDecoder('utf-8', { fatal: true }).decode(textBytes), isText: true };
    } catch {
      // Not a text after all: shown as bytes.
    }
  }
  return { text: bytes.map((byte) => byte.toString(16).padStart(2, '0')).join(' '), isText: false };
}
