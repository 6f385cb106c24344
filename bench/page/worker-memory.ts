import { readFileSync } from 'node:fs';
import type { Browser, CDPSession, Page } from '@playwright/test';
import type { Opened } from './stage';

/** Memory in use, in MB (10⁶ bytes), after a garbage collection. */
export interface MemoryUse {
  /** The largest worker: its objects, buffers and WebAssembly memories. */
  readonly workerMb: number;
  /** Workers alive. */
  readonly workers: number;
  /** Objects and buffers of the page itself. */
  readonly pageMb: number;
  /** Memory that the page's process has for itself, code included; `null` where the system does not say (it does on Linux). */
  readonly processMb: number | null;
}

interface HeapUsage {
  readonly usedSize: number;
  readonly embedderHeapUsedSize: number;
  readonly backingStorageSize: number;
}

const MB = 1e6;

/** From now on notes the VMs that workers make; the first run must not have begun. */
export function noteVms(page: Page): void {
  page.on('worker', (worker) => {
    worker.evaluate(watchVms).catch(() => undefined); // gone already: its run was dropped
  });
}

/** In a worker, before its run. What has been collected does not count. */
function watchVms(): void {
  const memories: WeakRef<WebAssembly.Memory>[] = [];
  const inside = globalThis as typeof globalThis & { benchVmBytes: () => number };
  inside.benchVmBytes = () => memories.reduce((sum, memory) => sum + (memory.deref()?.buffer.byteLength ?? 0), 0);
  WebAssembly.Instance = class extends WebAssembly.Instance {
    constructor(module: WebAssembly.Module, imports?: WebAssembly.Imports) {
      super(module, imports);
      const { memory } = this.exports;
      if (memory instanceof WebAssembly.Memory) memories.push(new WeakRef(memory));
    }
  };
}

/** Measures page and workers. */
export async function memoryUse({ browser, tools }: Opened): Promise<MemoryUse> {
  const workers = await withWorkers(tools, (ask) => workerBytes(ask));
  await tools.send('HeapProfiler.collectGarbage');
  const page = await tools.send('Runtime.getHeapUsage');
  return {
    workerMb: Math.max(0, ...workers) / MB,
    workers: workers.length,
    pageMb: heapBytes(page) / MB,
    processMb: await processMb(browser),
  };
}

const heapBytes = (heap: HeapUsage): number => heap.usedSize + heap.embedderHeapUsedSize + heap.backingStorageSize;

/** Sends a command of Chromium's tools to one worker. */
type Ask = <Answer>(method: string, params?: object) => Promise<Answer>;

/** The heap of a worker and the memories of its VMs, which Chromium does not count as heap. */
async function workerBytes(ask: Ask): Promise<number> {
  await ask('HeapProfiler.collectGarbage');
  const heap = await ask<HeapUsage>('Runtime.getHeapUsage');
  const vms = await ask<{ result: { value?: number } }>('Runtime.evaluate', {
    expression: 'globalThis.benchVmBytes?.()',
  });
  return heapBytes(heap) + (vms.result.value ?? 0);
}

/** Attaches to all workers that are alive, asks each of them, and leaves them again. */
async function withWorkers<T>(tools: CDPSession, work: (ask: Ask) => Promise<T>): Promise<T[]> {
  const found: string[] = [];
  const onFound = ({
    sessionId,
    targetInfo,
  }: {
    readonly sessionId: string;
    readonly targetInfo: { type: string };
  }): void => {
    if (targetInfo.type === 'worker') found.push(sessionId); // a service worker runs no program
  };
  const follow = (autoAttach: boolean): Promise<unknown> =>
    tools.send('Target.setAutoAttach', { autoAttach, waitForDebuggerOnStart: false, flatten: false });
  tools.on('Target.attachedToTarget', onFound);
  await follow(true);
  try {
    const results: T[] = [];
    for (const sessionId of found) results.push(await work(asker(tools, sessionId)));
    return results;
  } finally {
    await follow(false);
    tools.off('Target.attachedToTarget', onFound);
  }
}

/** Longest wait for a worker's answer, in ms: it answers between two slices of its run. */
const ANSWER_MS = 20_000;

let commands = 0;

function asker(tools: CDPSession, sessionId: string): Ask {
  return <Answer>(method: string, params: object = {}) => {
    commands += 1;
    const id = commands;
    return new Promise<Answer>((resolve, reject) => {
      const settle = (act: () => void): void => {
        clearTimeout(timer);
        tools.off('Target.receivedMessageFromTarget', hear);
        act();
      };
      const hear = (event: { readonly sessionId: string; readonly message: string }): void => {
        const said = JSON.parse(event.message) as { id?: number; result?: Answer; error?: { message: string } };
        if (event.sessionId !== sessionId || said.id !== id) return;
        settle(() => {
          if (said.error === undefined) resolve(said.result as Answer);
          else reject(new Error(`${method}: ${said.error.message}`));
        });
      };
      const timer = setTimeout(() => settle(() => reject(new Error(`${method}: no answer`))), ANSWER_MS);
      tools.on('Target.receivedMessageFromTarget', hear);
      const message = JSON.stringify({ id, method, params });
      tools.send('Target.sendMessageToTarget', { sessionId, message }).catch((error: unknown) => {
        settle(() => reject(new Error(`${method}: the worker is gone`, { cause: error })));
      });
    });
  };
}

/** The largest of the renderer processes is the page's; the others are Chromium's own empty ones. */
async function processMb(browser: Browser): Promise<number | null> {
  const tools = await browser.newBrowserCDPSession();
  const { processInfo } = await tools.send('SystemInfo.getProcessInfo');
  await tools.detach();
  const sizes = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => privateMb(id));
  const known = sizes.filter((size) => size !== null);
  return known.length === 0 ? null : Math.max(...known);
}

function privateMb(process: number): number | null {
  try {
    const text = readFileSync(`/proc/${process}/smaps_rollup`, 'utf8');
    const fields = text.matchAll(/^Private_(?:Clean|Dirty):\s+(\d+) kB$/gm);
    return Array.from(fields, ([, size]) => Number(size) * 1024).reduce((sum, bytes) => sum + bytes, 0) / MB;
  } catch {
    return null; // another system, or the process is gone
  }
}
