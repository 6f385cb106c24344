import type { Adapter, HostConnection } from '../adapter';
import type { EmbeddedSimulator } from '../simulator';
import { doCommand, type Outcome, type PageFacts } from './do-command';
import { limits } from './limits';
import type { CommandId, CommandName } from './protocol';
import { isOurs, PROTOCOL_VERSION, readCommand, refusal, type Incoming } from './read-command';
import { EventSender } from './event-sender';

/**
 * Makes the protocol adapter for our own dialect (`protocol.ts`). It sends nothing before the host's hello. Then it
 * answers every command with an id, one after the other, and sends the events that the host has chosen. A `stop` or
 * `reset` ends a `run` that has not begun yet, and anything else that waits for a run, whatever is between them.
 */
export function createParcoursAdapter(
  simulator: EmbeddedSimulator,
  connection: HostConnection,
  facts: PageFacts,
): Adapter {
  return new ParcoursAdapter(simulator, connection, facts);
}

/** The answer to a command that is not carried out. */
export const refusedMessage = (id: CommandId, problem: ReturnType<typeof refusal>): object => ({
  parcours: PROTOCOL_VERSION,
  reply: id,
  ok: false,
  ...problem,
});

class ParcoursAdapter implements Adapter {
  private readonly sender: EventSender;
  private unlisten: (() => void) | null = null;
  /** The current command; the others wait. */
  private busyWith: Incoming['asked'] | null = null;
  private isClosed = false;
  private readonly waiting: Incoming[] = [];

  constructor(
    private readonly simulator: EmbeddedSimulator,
    private readonly connection: HostConnection,
    private readonly facts: PageFacts,
  ) {
    this.sender = new EventSender(simulator, connection);
  }

  receive(message: unknown): void {
    if (this.isClosed) return;
    const incoming = read(message);
    if (incoming === null) return;
    const isEnd = endsRun(incoming);
    // A run that does not come can be given up, however many commands wait for it.
    if (this.waiting.length >= limits.waitingCommands * (isEnd ? 2 : 1)) {
      this.answer(incoming.id, { refused: refusal('busy', 'Too many commands wait for the one before them.') });
      return;
    }
    this.waiting.push(incoming);
    if (isEnd && this.awaitsRun()) void this.simulator.stop().catch(() => undefined);
    this.goOn();
  }

  /** True while a command waits for the run, which may take as long as the run lets it. */
  private awaitsRun(): boolean {
    const { busyWith } = this;
    return busyWith !== null && 'type' in busyWith && AWAIT_RUN.includes(busyWith.type);
  }

  close(): void {
    this.isClosed = true;
    this.waiting.length = 0;
    this.fallSilent();
  }

  /** Carries out the waiting commands, one after the other: answers stay in order. */
  private goOn(): void {
    while (this.busyWith === null && !this.isClosed) {
      const next = this.waiting.shift();
      if (next === undefined) return;
      const outcome = this.act(next);
      if (!(outcome instanceof Promise)) {
        this.answer(next.id, outcome);
        continue;
      }
      this.busyWith = next.asked;
      void outcome
        .catch((error: unknown) => broken(error))
        .then((came) => {
          this.busyWith = null;
          this.answer(next.id, came);
          this.goOn();
        });
    }
  }

  private act({ asked }: Incoming): Outcome | Promise<Outcome> {
    if ('code' in asked) return { refused: asked };
    if (asked.type === 'hello') this.unlisten ??= this.simulator.listen((event) => this.sender.tell(event));
    if (this.unlisten === null) return { refused: refusal('no-hello', 'Say hello first.') };
    if (asked.type === 'bye') this.fallSilent();
    // It would be given up at once, like a start that is under way.
    if (asked.type === 'run' && this.waiting.some(endsRun))
      return { refused: refusal('refused', 'The run was stopped before it began.') };
    try {
      const { simulator, sender, facts } = this;
      return doCommand(asked, { simulator, sender, facts });
    } catch (error) {
      return broken(error);
    }
  }

  private fallSilent(): void {
    this.unlisten?.();
    this.unlisten = null;
  }

  private answer(id: CommandId | null, outcome: Outcome): void {
    if (id === null || this.isClosed) return;
    if ('refused' in outcome) this.connection.post(refusedMessage(id, outcome.refused));
    else this.connection.post({ parcours: PROTOCOL_VERSION, reply: id, ok: true, ...outcome.done });
  }
}

/** Commands that a run which does not answer could hold up for good. */
const AWAIT_RUN: readonly CommandName[] = ['run', 'get-position', 'step-line', 'run-to', 'look-at', 'go-on'];

/** True if it ends a run, even one that has not begun. */
const endsRun = ({ asked }: Incoming): boolean => 'type' in asked && (asked.type === 'stop' || asked.type === 'reset');

/** `null` if it is not ours. A message of a page in the same realm may even throw when it is read. */
function read(message: unknown): Incoming | null {
  try {
    return isOurs(message) ? readCommand(message) : null;
  } catch {
    return null;
  }
}

const broken = (error: unknown): Outcome => ({
  refused: refusal('broken', `The app broke: ${error instanceof Error ? error.message : 'no more is known'}.`),
});
