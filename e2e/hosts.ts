import { once } from 'node:events';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';

import type { App } from './app';

/** The address of the tested app: `http://localhost:…/`. */
export const appAddress = (): string => process.env['PARCOURS_APP'] ?? 'http://localhost:8080/';

/** A page of another site. */
export interface HostPage {
  /** At 127.0.0.1, which to browsers is another site than localhost, where the app is. */
  readonly url: string;
  close(): void;
}

/** Serves one page on a site of its own. */
export async function hostPage(body: string): Promise<HostPage> {
  const server = createServer((_, response) => {
    response.writeHead(200, { 'Content-Type': 'text/html; charset=utf-8' });
    response.end(
      `<!doctype html><html lang="en"><title>Host</title><style>body{margin:0}</style><body>${body}</body></html>`,
    );
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}

/** True if something is in the page of the frame. */
export const isInFrame = (app: App, css: string): Promise<boolean> =>
  app.inFrame('iframe', (selector) => document.querySelector(selector) !== null, css);

/** The text of the console in the frame. */
export const consoleInFrame = (app: App): Promise<string> =>
  app.inFrame('iframe', () => document.querySelector('[role=log]')?.textContent ?? '');

/** Presses a button in the frame by script: no browser takes this for a gesture of the user. */
export const pressInFrame = (app: App, css: string): Promise<void> =>
  app.inFrame('iframe', (selector) => document.querySelector<HTMLElement>(selector)?.click(), css);

/** Puts a program into the editor of the frame, as from a worksheet. */
export const pasteInFrame = (app: App, text: string): Promise<void> =>
  app.inFrame(
    'iframe',
    (source) => {
      const editor = document.querySelector('.code-editor .cm-content');
      if (editor === null) throw new Error('The frame has no editor.');
      getSelection()?.selectAllChildren(editor);
      const event = new Event('paste', { bubbles: true, cancelable: true });
      Object.defineProperty(event, 'clipboardData', { value: { getData: () => source } });
      editor.dispatchEvent(event);
    },
    text,
  );
