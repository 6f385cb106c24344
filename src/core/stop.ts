/** Detaches, stops or unsubscribes what was attached, started or subscribed to. Calling it twice does no harm. */
export type Stop = () => void;
