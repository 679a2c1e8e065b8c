/** Programs that measure time, run by tasks of their own and never by the tests; tests hold the counts they rest on. */
package benchmarks;
