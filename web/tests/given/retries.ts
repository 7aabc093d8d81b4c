// Reports the tests that passed only when they were repeated.

import type { Reporter, TestModule } from "vitest/node";

export class Retries implements Reporter {
  onTestRunEnd(modules: readonly TestModule[]): void {
    for (const module of modules)
      for (const test of module.children.allTests()) {
        const { retryCount = 0 } = test.diagnostic() ?? {};
        if (retryCount > 0 && test.ok())
          console.warn(`passed at repetition ${retryCount}: ${test.fullName} (${module.moduleId})`);
      }
  }
}
