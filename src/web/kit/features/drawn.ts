import type { Component } from 'vue';

import { lateView } from '../late-view';
import type { LoadedView } from '../loaded-view';

/** A component that a feature brings: one that comes with the app, or one that is loaded when it is first drawn. */
export type Drawn = { readonly view: Component } | { readonly load: LoadedView };

/** The component to draw. Call it once per page: it is loaded once. */
export const viewOf = (drawn: Drawn): Component => ('view' in drawn ? drawn.view : lateView(drawn.load));
