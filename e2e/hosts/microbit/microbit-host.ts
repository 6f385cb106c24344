import { execFile } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import type { HostPage } from '../../hosts';
import type { SerialProgram } from './programs';

/** The host page's record of one simulator: see host.js. */
export interface SimulatorOfHost {
  readonly status: string;
  readonly state: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
  readonly serial: string;
  readonly radio: readonly string[];
  readonly log: { readonly headings: readonly string[]; readonly rows: readonly (readonly string[])[] };
  readonly errors: readonly string[];
  readonly kinds: readonly string[];
}

const FILES: Readonly<Record<string, string>> = { '/': 'text/html', '/host.js': 'text/javascript' };

/** Serves the host page at 127.0.0.1: to browsers another site than localhost, where the app is. */
export async function microbitHost(): Promise<HostPage> {
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://host').pathname;
    const type = FILES[path];
    response.writeHead(type === undefined ? 404 : 200, { 'Content-Type': `${type ?? 'text/plain'}; charset=utf-8` });
    response.end(
      type === undefined ? '' : readFileSync(new URL(path === '/' ? 'index.html' : `.${path}`, import.meta.url)),
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

/** The output of `npx parcours run` for a program, with line ends `\n`. */
export async function printedInNode({ source, typed, usesRepl = false }: SerialProgram): Promise<string> {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-host-'));
  try {
    writeFileSync(join(folder, 'main.py'), source);
    writeFileSync(join(folder, 'input.json'), JSON.stringify(typed ? [{ at: '1s', serial: typed.text }] : []));
    const inputs = typed ? ['--input', join(folder, 'input.json')] : [];
    const how = usesRepl ? ['--for', '3s'] : [];
    const args = ['bin/parcours.mjs', 'run', join(folder, 'main.py'), '--robot', 'none', ...inputs, ...how];
    return await new Promise((resolve) => {
      execFile('node', args, (_, stdout) => resolve(stdout.replaceAll('\r\n', '\n')));
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
