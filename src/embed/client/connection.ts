import type { Channel } from './channel';
import { ParcoursError } from './parcours-error';
import type { ClientEvents, CommandName, Commands, ConnectOptions, ErrorCode, Welcome } from './types';

/** Interval of repeated hellos, in ms. Chosen: a page takes longer to load, and nobody feels the wait. */
const HELLO_EVERY_MS = 250;
const HELLO_TIMEOUT_MS = 30_000;
const COMMAND_TIMEOUT_MS = 60_000;

interface Waiting {
  readonly done: (answer: object) => void;
  readonly failed: (error: ParcoursError) => void;
  readonly timer: ReturnType<typeof setTimeout>;
}

type Listener = (data: never) => void;

/** The conversation with one page: hello until it answers, commands and answers, events, restarts of the page. */
export class Connection {
  /** The page's last answer to hello. */
  welcome: Welcome | null = null;
  private readonly waiting = new Map<string, Waiting>();
  private readonly listeners = new Map<string, Set<Listener>>();
  private readonly session = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
  private greeting: Promise<Welcome> | null = null;
  private readonly helloIds = new Set<string>();
  private heardHello: (answer: Answer) => void = () => undefined;
  private endGreeting: (error: ParcoursError) => void = () => undefined;
  private wish: Commands['subscribe']['fields'];
  private isClosed = false;
  private lastId = 0;

  constructor(
    private readonly channel: Channel,
    private readonly options: ConnectOptions,
  ) {
    this.wish = options.subscribe ?? {};
  }

  /** Says hello until the page answers; recognises whether the page was loaded anew. */
  greet(): Promise<Welcome> {
    this.greeting ??= this.sayHello()
      .then((welcome) => this.begin(welcome))
      .finally(() => (this.greeting = null));
    return this.greeting;
  }

  /** Finds out whether the page was loaded anew, by another hello. */
  greetAgain(): void {
    if (this.welcome !== null && !this.isClosed) this.greet().catch(() => undefined);
  }

  /** Sends a command. @returns its answer @throws ParcoursError (as a rejection) if it was not carried out */
  send<N extends CommandName>(type: N, fields: Commands[N]['fields']): Promise<Commands[N]['result']> {
    if (this.isClosed) return Promise.reject(new ParcoursError('closed', 'The connection is closed.'));
    const id = this.nextId();
    const answer = new Promise<object>((done, failed) => {
      const limitMs = this.options.commandTimeoutMs ?? COMMAND_TIMEOUT_MS;
      const timer = setTimeout(() => this.fail(id, 'timeout', `No answer to "${type}" in time.`), limitMs);
      this.waiting.set(id, { done, failed, timer });
      try {
        postPlain(this.channel, { ...fields, parcours: 1, id, type });
      } catch {
        this.fail(id, 'not-plain', `"${type}" holds something other than plain data.`);
      }
    });
    // A subscription that the page refuses is not repeated after the page was loaded anew.
    if (type === 'subscribe') answer.then(() => (this.wish = { ...this.wish, ...fields })).catch(() => undefined);
    return answer;
  }

  on<E extends keyof ClientEvents>(event: E, listener: (data: ClientEvents[E]) => void): () => void {
    const all = this.listeners.get(event) ?? new Set();
    this.listeners.set(event, all.add(listener));
    return () => void all.delete(listener);
  }

  /** Two clients of one page hear each other's answers, so ids must be unique. */
  private nextId(): string {
    this.lastId += 1;
    return `${this.session}-${String(this.lastId)}`;
  }

  /** Takes a message of the page. */
  hear(data: unknown): void {
    if (this.isClosed || !isMessage(data)) return;
    if ('reply' in data) this.takeAnswer(data as unknown as Answer);
    else if (typeof data['type'] === 'string' && this.welcome !== null) this.emit(data['type'], data);
  }

  close(): void {
    if (this.isClosed) return;
    if (this.welcome !== null) postPlain(this.channel, { parcours: 1, type: 'bye' });
    this.isClosed = true;
    this.endGreeting(new ParcoursError('closed', 'The connection is closed.'));
    this.failAll('closed', 'The connection is closed.');
    this.listeners.clear();
    // A port that is closed at once may lose the last message.
    setTimeout(() => this.channel.close(), 0);
  }

  private sayHello(): Promise<Welcome> {
    const { client, timeoutMs = HELLO_TIMEOUT_MS } = this.options;
    return new Promise((done, failed) => {
      const hello = (): void => {
        const id = this.nextId();
        this.helloIds.add(id);
        const own = client === undefined ? {} : { client };
        this.channel.hello({ parcours: 1, id, type: 'hello', session: this.session, ...own });
      };
      const end = (act: () => void): void => {
        clearInterval(again);
        clearTimeout(late);
        this.helloIds.clear();
        act();
      };
      this.endGreeting = (error) => end(() => failed(error));
      this.heardHello = (answer) => {
        if (answer.ok) end(() => done(answer as unknown as Welcome));
        else this.endGreeting(errorOf(answer));
      };
      const again = setInterval(hello, HELLO_EVERY_MS);
      const text = `The page did not answer within ${String(timeoutMs)} ms. Is it there, and may this page command it?`;
      const late = setTimeout(() => this.endGreeting(new ParcoursError('timeout', text)), timeoutMs);
      hello();
    });
  }

  /** @throws ParcoursError (as a rejection) with `wrong-message` if the page does not know an event */
  private async begin(said: Welcome): Promise<Welcome> {
    const { versions, app, page, abilities } = said;
    const before = this.welcome;
    this.welcome = { versions, app, page, abilities };
    if (before !== null && before.page === page) return this.welcome;
    if (before !== null) this.failAll('restarted', 'The page was loaded anew before it answered.');
    const subscribed = Object.keys(this.wish).length > 0 ? this.send('subscribe', this.wish) : Promise.resolve();
    const isSubscribed = subscribed.catch((error: unknown) => {
      if (before === null && error instanceof ParcoursError && error.code === 'wrong-message') throw error;
    });
    if (before === null) await isSubscribed;
    else this.emit('restarted', this.welcome);
    return this.welcome;
  }

  private takeAnswer(answer: Answer): void {
    if (this.helloIds.has(answer.reply)) {
      this.heardHello(answer);
      return;
    }
    const waiting = this.waiting.get(answer.reply);
    if (waiting === undefined) return;
    if (!answer.ok && answer.code === 'no-hello') {
      this.greetAgain();
      this.fail(answer.reply, 'restarted', 'The page was loaded anew.');
      return;
    }
    clearTimeout(waiting.timer);
    this.waiting.delete(answer.reply);
    if (answer.ok) waiting.done(withoutEnvelope(answer));
    else waiting.failed(errorOf(answer));
  }

  private emit(event: string, data: object): void {
    for (const listener of [...(this.listeners.get(event) ?? [])]) {
      try {
        listener(withoutEnvelope(data) as never);
      } catch (error) {
        // An error in one listener must not keep the event from the others.
        setTimeout(() => {
          throw error;
        }, 0);
      }
    }
  }

  private fail(id: string, code: ErrorCode, message: string): void {
    const waiting = this.waiting.get(id);
    if (waiting === undefined) return;
    clearTimeout(waiting.timer);
    this.waiting.delete(id);
    waiting.failed(new ParcoursError(code, message));
  }

  private failAll(code: ErrorCode, message: string): void {
    for (const id of [...this.waiting.keys()]) this.fail(id, code, message);
  }
}

interface Answer {
  readonly reply: string;
  readonly ok: boolean;
  readonly code?: ErrorCode;
  readonly message?: string;
  readonly path?: string;
}

/** A faulty page may send anything in place of a text. */
function errorOf({ code, message, path }: Answer): ParcoursError {
  const textOf = (value: unknown): string => (typeof value === 'string' ? value : '');
  return new ParcoursError(typeof code === 'string' ? code : 'broken', textOf(message), textOf(path));
}

const isMessage = (data: unknown): data is Readonly<Record<string, unknown>> =>
  typeof data === 'object' && data !== null && (data as { parcours?: unknown }).parcours === 1;

const ENVELOPE: ReadonlySet<string> = new Set(['parcours', 'reply', 'ok', 'type']);

/** The content of a message without the common fields. An event's own `type` is its name, which the listener knows. */
function withoutEnvelope(data: object): object {
  return Object.fromEntries(Object.entries(data).filter(([key]) => !ENVELOPE.has(key)));
}

/** Data wrapped by a framework (a reactive object) cannot be cloned; as JSON it can. */
function postPlain(channel: Channel, message: object): void {
  try {
    channel.post(message);
  } catch {
    channel.post(JSON.parse(JSON.stringify(message)) as object);
  }
}
