import { createWorker } from './worker/create-worker';
import type { FromFilm, Pixels, ToFilm } from './worker/film';

export type { Pixels } from './worker/film';

/** Maximum number of pictures in transit: while one is written, the next is painted. */
const MOST_WAITING = 2;

/** A film in the making, in a worker of its own. */
export interface FilmClient {
  /**
   * Adds a picture, whose buffer is moved to the worker. Resolves when there is room for the next.
   * @throws Error (as a rejection) when it failed
   */
  add(pixels: Pixels, staysMs: number): Promise<void>;
  /** Ends the film and returns all of it. @throws Error (as a rejection) when it failed */
  finish(): Promise<Blob>;
  /** Ends the worker; an unfinished film is given up. */
  end(): void;
}

/**
 * Begins a film.
 *
 * @param samples some of its pictures, from which its colours are chosen; their buffers are moved to the worker
 * @throws Error where the browser allows no workers
 */
export function beginFilm(width: number, height: number, samples: readonly Pixels[]): FilmClient {
  const worker = createWorker();
  let waiting = 0;
  let gif: Uint8Array<ArrayBuffer> | null = null;
  let fault: Error | null = null;
  let wake: () => void = () => undefined;
  const fail = (message: string): void => {
    fault = new Error(message);
    wake();
  };
  worker.onmessage = ({ data }: MessageEvent<FromFilm>) => {
    if (data.type === 'film-taken') waiting -= 1;
    else if (data.type === 'film-made') gif = data.gif;
    else fail(data.message);
    wake();
  };
  worker.onerror = ({ message }) => fail(message);
  const send = (message: ToFilm, moved: readonly Pixels[]): void =>
    worker.postMessage(message, { transfer: moved.map(({ buffer }) => buffer) });
  /** Waits until a condition holds. @throws Error when the film has failed */
  async function until(isSo: () => boolean): Promise<void> {
    while (!isSo() && fault === null) await new Promise<void>((resolve) => (wake = resolve));
    if (fault !== null) throw fault;
  }
  send({ type: 'film-begin', width, height, samples }, samples);
  return {
    async add(pixels, staysMs) {
      waiting += 1;
      send({ type: 'film-picture', pixels, staysMs }, [pixels]);
      await until(() => waiting < MOST_WAITING);
    },
    async finish() {
      send({ type: 'film-end' }, []);
      await until(() => gif !== null);
      return new Blob(gif === null ? [] : [gif], { type: 'image/gif' });
    },
    end: () => worker.terminate(),
  };
}
