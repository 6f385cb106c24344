// The oldest browsers that the app runs in (decision 0073).

/** As the build's tools name them: what the syntax of scripts and styles has that these lack is lowered. */
export const OLDEST = ['chrome92', 'firefox115', 'safari15.4'];
