import { textBytesOf } from '#board/radio-text';
import { hexOf } from '#core/hex';
import type { RadioPacket } from '#simulation/outlets';
import { msOf } from '#simulation/report';

/** A packet that was sent, for `--json`: as text when `radio.send` made it, else its bytes in hexadecimal. */
export type SentPacket = { readonly atMs: number } & ({ readonly text: string } | { readonly hex: string });

/** Packets of a device since the last report, and the total number of its packets. */
export interface RadioNews {
  readonly packets: readonly SentPacket[];
  readonly count: number;
}

/** Maximum number of packets in the report; later ones are only counted. Chosen: ten minutes at 16 a second. */
const MOST_PACKETS = 10_000;

/** Maximum of bytes in a device's packets. Chosen: eight devices that send without a pause stay below 10 MB. */
const MOST_BYTES = 250_000;

/** Collects the packets of a device for the report. */
export class RadioKeeper {
  private packets: SentPacket[] = [];
  private count = 0;
  private kept = 0;
  private bytes = 0;

  add({ timeUs, bytes }: Pick<RadioPacket, 'timeUs' | 'bytes'>): void {
    this.count += 1;
    if (this.kept >= MOST_PACKETS || this.bytes + bytes.length > MOST_BYTES) return;
    this.kept += 1;
    this.bytes += bytes.length;
    const atMs = msOf(timeUs);
    const text = textBytesOf(bytes);
    this.packets.push(text === null ? { atMs, hex: hexOf(bytes) } : { atMs, text: new TextDecoder().decode(text) });
  }

  /** Returns the news since the last call. */
  take(): RadioNews {
    const { packets, count } = this;
    this.packets = [];
    return { packets, count };
  }
}
