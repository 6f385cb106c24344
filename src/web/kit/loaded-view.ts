import type { Component } from 'vue';

/** Loads a component. */
export type LoadedView = () => Promise<{ readonly default: Component }>;
