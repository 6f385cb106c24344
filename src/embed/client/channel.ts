import { targetOrigin } from '../nameable';

/** How the page is reached: the frame that shows it, its window, or a port that leads to it. */
export type Target = HTMLIFrameElement | Window | MessagePort;

/** A channel to the page and back. */
export interface Channel {
  /** Says hello; the message may get lost while the page is not ready yet. */
  hello(message: object): void;
  /** @throws DOMException for values that cannot be cloned */
  post(message: object): void;
  close(): void;
}

/** Handles a message of the page. */
export type Hear = (data: unknown) => void;

/** Opens the channel to a page; messages from elsewhere are ignored. */
export function openChannel(target: Target, origin: string | undefined, usePort: boolean, hear: Hear): Channel {
  if (isPort(target)) return portChannel(target, hear);
  const page = windowOf(target, origin);
  return usePort ? ownPortChannel(page, hear) : windowChannel(page, hear);
}

interface PageWindow {
  /** `null` while the frame is not in the document. */
  window(): Window | null;
  /** Origin of the page; `null` for any. */
  origin(): string | null;
}

function windowOf(target: HTMLIFrameElement | Window, origin: string | undefined): PageWindow {
  if (!isFrame(target)) return { window: () => target, origin: () => origin ?? null };
  return { window: () => target.contentWindow, origin: () => origin ?? originOf(target) };
}

/** True if it is a frame that shows the page. Checked by its name, because it may belong to another document. */
export const isFrame = (target: Target): target is HTMLIFrameElement =>
  Object.prototype.toString.call(target) === '[object HTMLIFrameElement]';

const isPort = (target: Target): target is MessagePort => target instanceof MessagePort;

/** The origin of a frame's page, from its address; `null` if it is unknown. */
function originOf(frame: HTMLIFrameElement): string | null {
  if (frame.hasAttribute('srcdoc') || !URL.canParse(frame.src)) return null;
  if (frame.hasAttribute('sandbox') && !frame.sandbox.contains('allow-same-origin')) return 'null';
  const { protocol, origin } = new URL(frame.src);
  return protocol === 'https:' || protocol === 'http:' ? origin : null;
}

function windowChannel(page: PageWindow, hear: Hear): Channel {
  const listen = (event: MessageEvent<unknown>): void => {
    const origin = page.origin();
    if (event.source !== null && event.source === page.window() && (origin === null || event.origin === origin))
      hear(event.data);
  };
  addEventListener('message', listen);
  const post = (message: object): void => page.window()?.postMessage(message, targetOrigin(page.origin()));
  return { hello: post, post, close: () => removeEventListener('message', listen) };
}

function portChannel(port: MessagePort, hear: Hear): Channel {
  port.onmessage = (event: MessageEvent<unknown>) => hear(event.data);
  const post = (message: object): void => port.postMessage(message);
  return { hello: post, post, close: () => port.close() };
}

/** Every hello brings a new port: one sent before the page listened is lost. The first that answers stays. */
function ownPortChannel(page: PageWindow, hear: Hear): Channel {
  let offered: MessagePort[] = [];
  let chosen: MessagePort | null = null;
  const drop = (but: MessagePort | null): void => {
    for (const port of offered) if (port !== but) port.close();
    offered = [];
  };
  return {
    hello(message) {
      const { port1, port2 } = new MessageChannel();
      offered.push(port1);
      port1.onmessage = (event: MessageEvent<unknown>) => {
        if (chosen !== port1 && offered.includes(port1)) {
          chosen?.close();
          chosen = port1;
          drop(port1);
        }
        if (chosen === port1) hear(event.data);
      };
      page.window()?.postMessage(message, targetOrigin(page.origin()), [port2]);
    },
    post: (message) => chosen?.postMessage(message),
    close() {
      drop(null);
      chosen?.close();
      chosen = null;
    },
  };
}
