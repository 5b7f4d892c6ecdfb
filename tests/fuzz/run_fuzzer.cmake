# cmake -DFUZZER=.. -DKIND=.. -DSECONDS=.. -DSOURCE=tests/fuzz -DFOUND=.. -P run_fuzzer.cmake: one fuzzer from its corpus and
# the kept inputs. New inputs go to a folder that is thrown away, so that the corpus stays as it is in the repository.
set(work ${FOUND}/${KIND}-corpus)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
set(folders ${work} ${SOURCE}/corpus/${KIND})
if(EXISTS ${SOURCE}/regressions/${KIND})
  list(APPEND folders ${SOURCE}/regressions/${KIND})
endif()
# One input may take 5 s and 2.5 GB: the largest picture that is read is 2 GB. Sanitizers slow things down, a shared
# machine does too; hence twice that.
execute_process(
  COMMAND ${FUZZER} -max_total_time=${SECONDS} -timeout=10 -rss_limit_mb=2560 -max_len=16384 -print_final_stats=1
    -dict=${SOURCE}/${KIND}.dict -artifact_prefix=${FOUND}/${KIND}- ${folders}
  OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
file(REMOVE_RECURSE ${work})
string(REGEX MATCHALL "stat::number_of_executed_units: [0-9]+" count "${text}")
if(NOT status EQUAL 0)
  string(LENGTH "${text}" length)
  if(length GREATER 12000)
    math(EXPR start "${length} - 12000")
    string(SUBSTRING "${text}" ${start} -1 text)
  endif()
  message(FATAL_ERROR "${text}\nfuzz_${KIND}: a finding; its input is in ${FOUND}. Keep it in tests/fuzz/regressions/${KIND}.")
endif()
message(STATUS "fuzz_${KIND}: no finding; ${count}")
