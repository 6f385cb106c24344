import type { LogEvent } from '#board/data-log';
import type { SoundEvent } from '#board/sound/sound-event';
import type { WayPoint } from './way';

/** A packet that the program sent by radio. */
export interface RadioPacket {
  /** Simulated time. */
  readonly timeUs: number;
  /** 0 … 255; only boards in the same group hear it. */
  readonly group: number;
  /** As it is on the air: `radio.send` puts 1, 0, 1 before the UTF-8 of its text. */
  readonly bytes: readonly number[];
}

/** Something that happened to the board's data log. */
export type TimedLogEvent = LogEvent & {
  /** Simulated time. */
  readonly timeUs: number;
};

/** Where a run's news go, the moment they happen. What nobody wants is not even made. */
export interface RunOutlets {
  /** What the program prints; left out, it is kept for `takeConsole`. */
  readonly print?: (text: string) => void;
  readonly sound?: (event: SoundEvent) => void;
  readonly radio?: (packet: RadioPacket) => void;
  readonly log?: (event: TimedLogEvent) => void;
  /** Where the robot comes by, a point every few mm. */
  readonly way?: (point: WayPoint) => void;
}
