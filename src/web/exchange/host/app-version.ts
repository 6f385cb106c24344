/** Put in by the build. */
declare const __APP_VERSION__: string;

/** Version of the app, as its package has it. */
export const appVersion: string = __APP_VERSION__;
