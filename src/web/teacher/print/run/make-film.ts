import { clockText } from '../../../session/run/use-run-text';
import { beginFilm, type Pixels } from '../../../session/run/film-client';
import type { RunTape } from '../../../session/run/unpack-tape';
import { lightPalette } from '../../../pupil/arena/model/palette';
import { drawPill } from '../../../pupil/arena/picture/draw-pill';
import { FRAME_US } from './stretch';
import type { RunPainter } from './run-painter';

/** Number of pictures from which the colours of a film are chosen. */
const SAMPLES = 5;
/** The last picture stays, so that the end is seen before it begins again. */
const LAST_MS = 1500;

/** The options of a film. */
export interface FilmWish {
  readonly painter: RunPainter;
  readonly tape: RunTape;
  readonly times: readonly number[];
  /** Hears how many of its pictures are done. */
  readonly tell: (done: number) => void;
  /** Gives it up. */
  readonly signal: AbortSignal;
}

/**
 * Makes a GIF of a run: the page paints picture after picture and rests between them, a worker writes them.
 *
 * @throws Error (as a rejection) when it was given up, or failed
 */
export async function makeFilm({ painter, tape, times, tell, signal }: FilmWish): Promise<Blob> {
  const samples: Pixels[] = [];
  for (let n = 0; n < SAMPLES; n++) {
    const pixels = pixelsAt(painter, tape, times[Math.round(((times.length - 1) * n) / (SAMPLES - 1))] ?? 0);
    if (pixels !== null) samples.push(pixels);
    await rest(signal);
  }
  const film = beginFilm(painter.widthPx, painter.heightPx, samples);
  const giveUp = new Promise<never>((_, reject) => {
    signal.addEventListener('abort', () => reject(new Error('It was given up.')));
  });
  giveUp.catch(() => undefined); // nobody waits for it once the film is done
  try {
    for (const [at, timeUs] of times.entries()) {
      const pixels = pixelsAt(painter, tape, timeUs);
      const next = times[at + 1];
      const staysMs = next === undefined ? LAST_MS : Math.max(FRAME_US, next - timeUs) / 1000;
      if (pixels !== null) await Promise.race([film.add(pixels, staysMs), giveUp]);
      tell(at + 1);
      await rest(signal);
    }
    return await Promise.race([film.finish(), giveUp]);
  } finally {
    film.end();
  }
}

/** Lets the page work in between. @throws Error (as a rejection) when the film was given up */
async function rest(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
}

/** The arena at a time with its clock, as pixels. */
function pixelsAt(painter: RunPainter, { rows }: RunTape, timeUs: number): Pixels | null {
  const moment = rows.at(timeUs);
  if (moment === null) return null;
  const canvas = filmPicture(painter, moment, timeUs);
  const context = canvas.getContext('2d');
  return context === null ? null : context.getImageData(0, 0, canvas.width, canvas.height).data;
}

/** A picture of a film: the arena with the time in its lower right corner. */
export function filmPicture(
  painter: RunPainter,
  moment: Parameters<RunPainter['paint']>[0],
  timeUs: number,
): HTMLCanvasElement {
  const canvas = painter.paint(moment);
  const context = canvas.getContext('2d');
  const corner = { x: canvas.width, y: canvas.height };
  if (context !== null) drawPill(context, clockText(timeUs), corner, painter, lightPalette);
  return canvas;
}
