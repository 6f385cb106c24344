import type { Board } from '#board/board';
import type { Vec } from '#core/geometry';
import type { Sensors } from '#board/sensors/sensors';
import { lengthOf } from '#scene/outline';

/** A board that may sound, and where it is, in mm. */
export interface Speaker {
  readonly board: Pick<Board, 'music' | 'sound'>;
  readonly at: Vec;
}

/**
 * Distance at which a speaker at full volume brings the microphone to the top of its scale. Chosen: two boards on one table; the
 * sound's pitch, the walls and what stands in between are left out.
 */
const FULL_MM = 300;
/** Farther away nothing is heard. Chosen: the room is louder than that. */
const REACH_MM = 2000;

/** How loud others are here, 0 … 255: the loudest alone counts, and it weakens with the distance. */
export function levelAt(here: Vec, speakers: readonly Speaker[]): number {
  const levels = speakers.map(({ board, at }) => {
    const farMm = lengthOf(at.x - here.x, at.y - here.y);
    return farMm > REACH_MM ? 0 : (loudnessOf(board) * FULL_MM) / Math.max(farMm, FULL_MM);
  });
  return Math.round(Math.max(0, ...levels));
}

/** Loudness of its speaker, 0 … 255: every sound is as loud as the volume. */
const loudnessOf = (board: Speaker['board']): number => (isSounding(board) ? board.sound.volume : 0);

/** True while its speaker gives a tone or a sound, however softly. */
export const isSounding = ({ music, sound }: Speaker['board']): boolean =>
  sound.isSpeakerOn && (music.frequencyHz !== null || sound.isSounding);

/** Lets a microphone hear the speakers of other boards, as a level. */
export class Hearing {
  private listens = false;
  /** The level without the others, and the one that was set last. */
  private own = 0;
  private last = 0;

  /** @param heard level of the others now, 0 … 255 */
  constructor(
    private readonly sensors: Pick<Sensors, 'get' | 'set'>,
    private readonly heard: () => number,
  ) {}

  get isOn(): boolean {
    return this.listens;
  }

  /** Switches it on or off; off restores the level without the others. */
  switch(on: boolean): void {
    if (on === this.listens) return;
    this.listens = on;
    if (on) this.own = this.last = this.sensors.get('soundLevel');
    else this.tell(this.ownNow());
    this.step();
  }

  /** Call it after each step of the world. */
  step(): void {
    if (!this.listens) return;
    this.own = this.ownNow();
    this.tell(Math.max(this.own, this.heard()));
  }

  /** The level without the others; a value set by hand since then is that level. */
  private ownNow(): number {
    const now = this.sensors.get('soundLevel');
    return now === this.last ? this.own : now;
  }

  private tell(level: number): void {
    this.last = level;
    if (this.sensors.get('soundLevel') !== level) this.sensors.set('soundLevel', level);
  }
}
