import { ParcoursSimulatorElement } from './parcours-simulator';

export { ParcoursError } from '../client/parcours-error';
export type * from '../client/types';
export { ParcoursSimulatorElement, type ParcoursSimulatorEvents } from './parcours-simulator';

const NAME = 'parcours-simulator';

// Outside a browser, where a page is only rendered, there are no elements.
if ('customElements' in globalThis && customElements.get(NAME) === undefined)
  customElements.define(NAME, ParcoursSimulatorElement);

declare global {
  interface HTMLElementTagNameMap {
    'parcours-simulator': ParcoursSimulatorElement;
  }
}
