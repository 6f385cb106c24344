import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import type { ProbeResult, ProbeTask } from './probe/messages';
import type { runBare } from './probe/run-bare';

/** The run of a probe in Node, to compare with what it gives in the worker of an engine. */
export async function runInNode(task: Omit<ProbeTask, 'firmware'>): Promise<ProbeResult> {
  const firmware = new WebAssembly.Module(readFileSync(new URL('../.cache/vm/vm.wasm', import.meta.url)));
  // Playwright's own loader takes no JSON, which the VM's library is.
  const bare = fileURLToPath(new URL('./probe/run-bare.ts', import.meta.url));
  const { module } = await runnerImport<{ readonly runBare: typeof runBare }>(bare, {
    configFile: false,
    logLevel: 'warn',
  });
  return module.runBare({ ...task, firmware });
}
