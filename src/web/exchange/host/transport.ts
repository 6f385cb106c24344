import type { Adapter } from '#embed/adapter';
import { targetOrigin } from '#embed/nameable';

import { lateAdapter, type OpenLate } from './late-adapter';

/** The relevant fields of a `MessageEvent`. */
export interface HostMessage {
  readonly data: unknown;
  readonly origin: string;
  readonly source: unknown;
  readonly ports: readonly MessagePort[];
}

/** The embedding page. */
export interface ParentPage {
  postMessage(message: object, targetOrigin: string): void;
}

/** The embedding page, and the dialects for it. */
export interface TransportOptions {
  readonly parent: ParentPage;
  /** Origins that may command; `null` for any. */
  readonly allowed: readonly string[] | null;
  /** Our own dialect, for hosts that say hello. */
  readonly openOurs: OpenLate;
  /** The dialect that the page speaks before it is asked, or `null`. */
  readonly openUnasked: OpenLate | null;
  readonly nowMs: () => number;
  /** The code of a dialect could not be fetched. */
  readonly onMissing: () => void;
}

/** The only entrance for messages of other pages. */
export interface HostTransport {
  receive(message: HostMessage): void;
  close(): void;
}

/**
 * Lets only the parent speak: neither children, siblings nor the opener of the window. The first origin that says hello
 * in our own dialect is the only one that may command from then on; answers are sent to it by name.
 */
export function openTransport(options: TransportOptions): HostTransport {
  const { parent, allowed, openOurs, openUnasked, nowMs, onMissing } = options;
  let partner: Partner | null = null;
  /** The receivers of unrequested messages: all allowed origins, until one has spoken. */
  let audience = allowed?.map(targetOrigin) ?? ['*'];
  const unasked =
    openUnasked === null
      ? null
      : lateAdapter(
          openUnasked,
          { post: (message) => audience.forEach((origin) => post(parent, message, origin)), nowMs },
          { onMissing, onLost: () => undefined }, // these dialects have no word for it
        );

  function takeHello(session: unknown, message: HostMessage): void {
    const [port, ...more] = message.ports;
    for (const one of more) one.close();
    // A host repeats its hello until it is answered: the same conversation continues.
    if (partner !== null && typeof session === 'string' && partner.session === session && partner.isOpen()) {
      port?.close();
      partner.receive(message.data);
      return;
    }
    partner?.close();
    const say = { parent, origin: message.origin, port: port ?? null };
    partner = openPartner(say, session, (send) => {
      const onLost = (lost: unknown, code: 'busy' | 'broken'): void =>
        refuse(send, isOurs(lost) ? lost.id : null, code);
      return lateAdapter(openOurs, { post: send, nowMs }, { onMissing, onLost });
    });
    partner.receive(message.data);
  }

  return {
    receive(message) {
      if (message.source !== parent || allowed?.includes(message.origin) === false) return;
      const { data, origin } = message;
      if (!isOurs(data)) {
        audience = [targetOrigin(origin)];
        unasked?.receive(data);
        return;
      }
      if (partner !== null && partner.origin !== origin) return;
      const { type, session, id } = data;
      if (type === 'hello') takeHello(session, message);
      // When the page is reloaded, its host keeps sending: it is told to say hello again.
      else if (partner === null) refuse((answer) => post(parent, answer, targetOrigin(origin)), id, 'no-hello');
      else if (partner.isOnWindow) partner.receive(data);
    },
    close() {
      partner?.close();
      unasked?.close();
    },
  };
}

/** The host that has said hello. */
interface Partner {
  readonly origin: string;
  readonly session: unknown;
  /** True if it sends its messages to the window; otherwise it uses its port alone. */
  readonly isOnWindow: boolean;
  isOpen(): boolean;
  receive(data: unknown): void;
  close(): void;
}

interface PartnerWay {
  readonly parent: ParentPage;
  readonly origin: string;
  readonly port: MessagePort | null;
}

function openPartner(
  { parent, origin, port }: PartnerWay,
  session: unknown,
  open: (send: (message: object) => void) => Adapter,
): Partner {
  const target = targetOrigin(origin);
  let isOpen = true;
  const adapter = open((message) => (port === null ? post(parent, message, target) : postTo(port, message)));
  const close = (): void => {
    isOpen = false;
    adapter.close();
    port?.close();
  };
  if (port !== null) {
    port.onmessage = (event: MessageEvent<unknown>) => adapter.receive(event.data);
    // In browsers that report it: the host is gone and may come back with another hello.
    port.addEventListener('close', close);
  }
  return {
    origin,
    session,
    isOnWindow: port === null,
    isOpen: () => isOpen,
    receive: (data) => adapter.receive(data),
    close,
  };
}

/** Why a command is refused before it is read. */
const REFUSALS = {
  'no-hello': 'Say hello first.',
  busy: 'Too many commands wait for the page.',
  broken: 'A part of the page could not be fetched.',
} as const;

/** Answers a command of our own dialect while its code is missing. */
function refuse(send: (message: object) => void, id: unknown, code: keyof typeof REFUSALS): void {
  if (typeof id !== 'number' && (typeof id !== 'string' || id.length > LONGEST_ID)) return;
  send({ parcours: 1, reply: id, ok: false, code, message: REFUSALS[code], path: '' });
}

/** Equals `limits.idCharacters` of the dialect, whose code is not loaded yet. */
const LONGEST_ID = 100;

/** True if it is a message of our own dialect, of any version. */
const isOurs = (data: unknown): data is Readonly<Record<'type' | 'session' | 'id', unknown>> =>
  typeof data === 'object' && data !== null && 'parcours' in data && typeof data.parcours === 'number';

function post(parent: ParentPage, message: object, target: string): void {
  try {
    parent.postMessage(message, target);
  } catch {
    // The message cannot be cloned: a host that receives nothing is better than a page that fails.
  }
}

function postTo(port: MessagePort, message: object): void {
  try {
    port.postMessage(message);
  } catch {
    // As above: this message cannot be cloned either.
  }
}
