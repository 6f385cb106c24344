import code from 'single:worker';

import { once } from '#core/memo';

const address = once(() => URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));

/**
 * Makes the worker of the single file: its code is in the page and gets an address of its own there. It inherits the
 * page's policy, and with it `connect-src 'none'`.
 *
 * @throws Error if the browser allows no workers
 */
export function createWorker(): Worker {
  return new Worker(address());
}
