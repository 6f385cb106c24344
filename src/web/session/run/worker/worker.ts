/**
 * The worker that owns one run, inspects a past one or repeats it (`look/`), fits one robot (`fit.ts`), serves beside a run
 * (`serve/`: checks, runs by the hundred, hints), reads hand-ins (`reader.ts`), makes a film (`film.ts`) or a hex (`hex.ts`). A run exchanges the messages of
 * `protocol.ts`; its logic is in `runner.ts`.
 */
import '../../../kit/oldest/fill';

import { Simulation } from '#simulation/simulation';

import type { createFilmMaker, ToFilm } from './film';
import type { FitAnswer, FitRequest } from './fit';
import type { HexAnswer, HexRequest } from './hex';
import type { Looker } from './look/looker';
import type { FromLooker, ToLooker } from './look/protocol';
import type { RepeatAnswer, RepeatRequest } from './look/repeat';
import type { Reader, ToReader } from './reader';
import { sealSandbox } from './sandbox';
import { packPictures } from './pictures';
import type { ToWorker } from './protocol';
import { Runner } from './runner';
import type { FromServer, ToServer } from './serve/protocol';
import type { Server } from './serve/server';

sealSandbox(globalThis);

// A message to itself arrives immediately, but after the messages already waiting: setTimeout would add 4 ms each time.
const channel = new MessageChannel();
let next: (() => void) | null = null;
channel.port1.onmessage = () => {
  const task = next;
  next = null;
  task?.();
};

function soon(task: () => void): void {
  next = task;
  channel.port2.postMessage(null);
}

const pack = packPictures();
const runner = new Runner({
  post: (message) => postMessage(pack(message)),
  nowMs: () => performance.now(),
  later(task, delayMs) {
    if (delayMs > 0) setTimeout(task, delayMs);
    else soon(task);
  },
  create: (setup, firmware, outlets) => Simulation.create(setup, firmware, outlets),
});

/** Loaded on demand: no run needs the code that looks into a past one. */
let looker: Promise<Looker> | null = null;
const loadLooker = (): Promise<Looker> =>
  (looker ??= import('./look/looker').then(
    (late) =>
      new late.Looker({
        post: (message) => postMessage(message),
        nowMs: () => performance.now(),
        rest: () => new Promise((resolve) => soon(resolve)),
      }),
  ));

/** Loaded on demand, too: the code that serves beside a run. */
let server: Promise<Server> | null = null;
const loadServer = (): Promise<Server> =>
  (server ??= import('./serve/server').then(
    (late) => new late.Server({ post: (message) => postMessage(message), nowMs: () => performance.now() }),
  ));

const isForLooker = (data: Asked): data is ToLooker =>
  data.type === 'why' || data.type === 'look-into' || data.type === 'look' || data.type === 'look-near';

/** Loaded on demand as well. */
let reader: Promise<Reader> | null = null;
const loadReader = (): Promise<Reader> => (reader ??= import('./reader').then((late) => new late.Reader()));

/** Loaded on demand, as the others. */
let filmMaker: Promise<ReturnType<typeof createFilmMaker>> | null = null;
const loadFilmMaker = (): NonNullable<typeof filmMaker> =>
  (filmMaker ??= import('./film').then((late) => late.createFilmMaker((message) => postMessage(message))));

type Asked = ToWorker | ToLooker | RepeatRequest | FitRequest | HexRequest | ToServer | ToReader | ToFilm;

addEventListener('message', ({ data }: MessageEvent<Asked>) => {
  if (data.type === 'repeat')
    void import('./look/repeat').then(
      (late) => late.answerRepeat(data, { post: (message) => postMessage(message), nowMs: () => performance.now() }),
      (error: unknown) => postMessage({ type: 'failed', message: String(error) } satisfies RepeatAnswer),
    );
  else if (data.type === 'fit')
    void import('./fit')
      .then(({ answerFit }) => answerFit(data))
      .catch((error: unknown): FitAnswer => ({ type: 'failed', message: String(error) }))
      .then((answer) => postMessage(answer));
  else if (data.type === 'make-hex')
    void import('./hex')
      .then(({ answerHex }) => answerHex(data))
      .catch((error: unknown): HexAnswer => ({ type: 'failed', message: String(error) }))
      .then((answer) => postMessage(answer));
  else if (isForLooker(data))
    void loadLooker().then(
      (it) => it.receive(data),
      (error: unknown) => postMessage({ type: 'look-failed', message: String(error) } satisfies FromLooker),
    );
  else if (data.type === 'serve-open' || data.type === 'serve')
    void loadServer().then(
      (it) => it.receive(data),
      (error: unknown) => {
        // Whoever asks hears that its code did not come; a program is not to blame.
        if (data.type === 'serve')
          postMessage({ type: 'served', answer: { broken: String(error) } } satisfies FromServer);
      },
    );
  else if (data.type === 'read-open' || data.type === 'read')
    void loadReader()
      .then((it) => it.answer(data))
      .then((answer) => postMessage(answer));
  else if (data.type === 'film-begin' || data.type === 'film-picture' || data.type === 'film-end')
    void loadFilmMaker().then((tell) => tell(data));
  else runner.receive(data);
});
