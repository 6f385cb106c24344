import { sha256 } from '@noble/hashes/sha2.js';
import { hexOf } from '#core/hex';
import { endedWord, type EndedWord } from '#simulation/report';
import type { Simulation } from '#simulation/simulation';

/** The outcome of a run: equal in every repetition. */
export interface TapeResult {
  readonly simulatedUs: number;
  /** Fingerprint of the robots' trajectories. */
  readonly traceHash: string;
  readonly devices: readonly DeviceResult[];
}

/** The outcome of a device. */
export interface DeviceResult {
  readonly name: string;
  /** `null`: its program goes on. */
  readonly ended: EndedWord | null;
  /** Free bytes on its heap. */
  readonly heapFree: number;
  /** SHA-256 of what it has printed, as UTF-8. */
  readonly outputHash: string;
}

/** SHA-256 of a text as UTF-8, 64 hexadecimal digits. */
export const hashOfText = (text: string): string => hexOf(sha256(new TextEncoder().encode(text)));

/** The hashes of what the devices print, for the result. */
export class OutputHashes {
  private readonly hashes: ReturnType<typeof sha256.create>[];
  private readonly encoder = new TextEncoder();

  constructor(devices: number) {
    this.hashes = Array.from({ length: devices }, () => sha256.create());
  }

  add(text: string, device: number): void {
    this.hashes[device]?.update(this.encoder.encode(text));
  }

  hex(device: number): string {
    return hexOf(this.hashes[device]?.clone().digest() ?? new Uint8Array());
  }
}

/** The result of a run now. */
export function resultOf(simulation: Simulation, output: OutputHashes): TapeResult {
  const { others, name } = simulation.snapshot();
  const devices = [name, ...others.map((device) => device.name)].map((device, place): DeviceResult => {
    const ended = simulation.endings[place] ?? null;
    return {
      name: device,
      ended: ended && endedWord(ended),
      heapFree: simulation.heapFree(place),
      outputHash: output.hex(place),
    };
  });
  return { simulatedUs: simulation.nowUs, traceHash: simulation.traceHash, devices };
}

/** The differences of a repetition from the recording, a sentence each; none: it is the same run. */
export function differences(recorded: TapeResult, repeated: TapeResult): readonly string[] {
  const found: string[] = [];
  const compare = (what: string, before: unknown, now: unknown): void => {
    if (before !== now) found.push(`${what}: ${String(before)} in the recording, ${String(now)} now.`);
  };
  compare('Simulated time in µs', recorded.simulatedUs, repeated.simulatedUs);
  compare('The way of the robots (hash)', recorded.traceHash, repeated.traceHash);
  for (const [place, device] of recorded.devices.entries()) {
    const now = repeated.devices[place];
    compare(`${device.name}, how the program ended`, device.ended ?? 'not yet', now?.ended ?? 'not yet');
    compare(`${device.name}, free memory`, device.heapFree, now?.heapFree);
    compare(`${device.name}, output (hash)`, device.outputHash, now?.outputHash);
  }
  return found;
}
