/** Makes a GIF of successive pictures. Loaded into the worker on demand: no run needs it. */
import { applyPalette, GIFEncoder, quantize, type Colour } from 'gifenc';

/** Pixels of a picture: red, green, blue and alpha, 0 … 255 each, row by row. */
export type Pixels = Uint8ClampedArray<ArrayBuffer>;

/** From the page. */
export type ToFilm =
  /** `samples`: some of the following pictures, from which the film's colours are chosen. */
  | {
      readonly type: 'film-begin';
      readonly width: number;
      readonly height: number;
      readonly samples: readonly Pixels[];
    }
  /** The next picture, and how long it stays, in ms (whole tens). Answered by `film-taken`. */
  | { readonly type: 'film-picture'; readonly pixels: Pixels; readonly staysMs: number }
  /** The previous picture was the last one. Answered by `film-made`. */
  | { readonly type: 'film-end' };

/** To the page. */
export type FromFilm =
  | { readonly type: 'film-taken' }
  | { readonly type: 'film-made'; readonly gif: Uint8Array<ArrayBuffer> }
  | { readonly type: 'film-failed'; readonly message: string };

/** A GIF has 256 colours; one of them means unchanged since the previous picture. */
const MOST_COLOURS = 255;

/** Every seventh pixel of a sample is used. Chosen: a prime hits all columns of most widths. */
const SAMPLED = 7;

/** Takes pictures of one size, and writes only the changes into each. */
export class Film {
  private readonly gif = GIFEncoder();
  private readonly colours: readonly Colour[];
  private readonly same: number;
  private before: Uint32Array | null = null;

  constructor(
    private readonly width: number,
    private readonly height: number,
    samples: readonly Pixels[],
  ) {
    this.colours = quantize(sampled(samples), MOST_COLOURS);
    this.same = this.colours.length;
  }

  /** Adds a picture. @param staysMs how long it is to be seen, in whole tens of ms */
  add(pixels: Pixels, staysMs: number): void {
    const now = new Uint32Array(pixels.buffer);
    const { before, width, height, colours, same } = this;
    this.before = now;
    if (before === null) {
      const palette = [...colours, [0, 0, 0] as const];
      this.gif.writeFrame(applyPalette(pixels, colours), width, height, { palette, delay: staysMs, dispose: 1 });
      return;
    }
    const index = new Uint8Array(now.length).fill(same);
    const changed = now.reduce<number[]>((all, pixel, at) => {
      if (pixel !== before[at]) all.push(at);
      return all;
    }, []);
    const news = Uint32Array.from(changed, (at) => now[at] ?? 0);
    const found = applyPalette(new Uint8ClampedArray(news.buffer), colours);
    for (const [n, at] of changed.entries()) index[at] = found[n] ?? same;
    const how = { transparent: true, transparentIndex: same, dispose: 1 };
    this.gif.writeFrame(index, width, height, { ...how, delay: staysMs });
  }

  /** The whole film, which begins again whenever it has ended. */
  end(): Uint8Array<ArrayBuffer> {
    this.gif.finish();
    return this.gif.bytes();
  }
}

/** Some pixels of all samples. */
function sampled(samples: readonly Pixels[]): Uint8ClampedArray {
  const some = samples.flatMap((pixels) => {
    const all = new Uint32Array(pixels.buffer);
    return Array.from({ length: Math.ceil(all.length / SAMPLED) }, (_, n) => all[n * SAMPLED] ?? 0);
  });
  return new Uint8ClampedArray(Uint32Array.from(some).buffer);
}

/** Answers the page. An error ends the film, and is reported. */
export function createFilmMaker(post: (message: FromFilm) => void): (message: ToFilm) => void {
  let film: Film | null = null;
  return (message) => {
    try {
      if (message.type === 'film-begin') film = new Film(message.width, message.height, message.samples);
      else if (film === null) throw new Error('The film has not begun.');
      else if (message.type === 'film-end') post({ type: 'film-made', gif: film.end() });
      else {
        film.add(message.pixels, message.staysMs);
        post({ type: 'film-taken' });
      }
    } catch (error) {
      film = null;
      post({ type: 'film-failed', message: error instanceof Error ? error.message : String(error) });
    }
  };
}
