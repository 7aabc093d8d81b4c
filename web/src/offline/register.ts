// Lets a published page open without a network after the first visit.

/** The file that vite.config.ts builds from service_worker.ts. */
const SCRIPT = "./offline.js";

/** A server on this machine may serve another page at the same address tomorrow. */
const isLocal = (host: string) => host === "localhost" || /^127\.|^\[::1\]$/.test(host);

/** Registers the service worker of a published page, once the page has loaded. Visitors who save data are spared the
 * parts that they may never use. */
export function keepForOffline(): void {
  const { connection, serviceWorker } = navigator as Navigator & {
    connection?: { saveData?: boolean };
  };
  // Undefined where the page has no secure address.
  if (!serviceWorker || isLocal(location.hostname) || connection?.saveData) return;
  const register = () => void serviceWorker.register(SCRIPT).catch(console.error);
  if (document.readyState === "complete") register();
  else addEventListener("load", register, { once: true });
}
