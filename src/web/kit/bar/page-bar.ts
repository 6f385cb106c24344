import { createApp, shallowRef } from 'vue';

import { controls } from '../controls/controls';
import PageBar from './PageBar.vue';
import type { PageMessage } from './page-message';

/**
 * Time for which a message is shown that asks nothing, in ms. Chosen: as long as the short notices that offer
 * something.
 */
const SHOWN_MS = 12_000;

const messages = shallowRef<readonly PageMessage[]>([]);
let isMounted = false;

/** Shows a message. The bar is a small app of its own, made with the first message. */
export function showPageBar(message: PageMessage): void {
  closePageBar(message.kind);
  messages.value = [...messages.value, message];
  if (message.actions.length === 0) {
    setTimeout(() => {
      messages.value = messages.value.filter((shown) => shown !== message);
    }, SHOWN_MS);
  }
  if (isMounted) return;
  isMounted = true;
  const place = document.createElement('div');
  document.body.append(place);
  createApp(PageBar, { messages, onClose: closePageBar }).use(controls).mount(place);
}

/** Takes the message of a kind away, if there is one. */
export function closePageBar(kind: PageMessage['kind']): void {
  messages.value = messages.value.filter((message) => message.kind !== kind);
}
